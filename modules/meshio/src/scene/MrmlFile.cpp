// SPDX-License-Identifier: BSD-3-Clause
#include "scene/BlockFile.h"

#include "guard/PreScan.h"
#include "text/Encoding.h"
#include "text/Fault.h"
#include "text/TextScan.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <QUrl>
#include <QXmlStreamReader>

#include <cmath>
#include <map>
#include <utility>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;
namespace fs = std::filesystem;

/// A node of the scene.
struct MrmlNode
{
    std::string kind; ///< element, "Model"
    std::map<std::string, std::string> attributes;

    [[nodiscard]] std::string at(const std::string& name) const
    {
        const auto found = attributes.find(name);
        return found == attributes.end() ? std::string() : found->second;
    }
    /// @param role  "display", "storage" or "transform"
    /// @return the id of the first node with this role; empty without one
    [[nodiscard]] std::string reference(const std::string& role) const
    {
        const std::string all = ";" + at("references"), word = ";" + role + ":";
        const std::size_t place = all.find(word);
        std::string_view rest = all;
        rest.remove_prefix(place == std::string::npos ? all.size() : place + word.size());
        rest = rest.substr(0, rest.find(';'));
        const std::string old = at(role + "NodeRef"); // of older versions
        std::string_view oldRest = old;
        const std::string_view id = takeWord(rest);
        return std::string(id.empty() ? takeWord(oldRest) : id);
    }
};

/// @return as many numbers as fit; empty if a word is no number
template<std::size_t kCount>
std::optional<std::array<double, kCount>> numbersOf(const std::string& text)
{
    std::array<double, kCount> out = {};
    std::string_view rest = text;
    for (double& number : out) {
        const std::optional<double> value = wordToNumber(takeWord(rest));
        if (!value || !std::isfinite(*value)) {
            return std::nullopt;
        }
        number = *value;
    }
    return out;
}

class MrmlReader
{
  public:
    MrmlReader(std::string_view bytes, const fs::path& path)
        : m_xml(QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(bytes.size())))
        , m_path(path)
        , m_file(utf8Of(path.filename().string()))
    {
    }
    Result<Blocks> run();

  private:
    Status readNodes();
    void addBlock(const MrmlNode& node);
    [[nodiscard]] bool setTransform(const MrmlNode& node, Block& block) const;
    [[nodiscard]] std::optional<fs::path> fileOf(const MrmlNode& storage) const;
    [[nodiscard]] const MrmlNode* find(const std::string& id) const
    {
        const auto found = m_nodes.find(id);
        return found == m_nodes.end() ? nullptr : &found->second;
    }

    QXmlStreamReader m_xml;
    fs::path m_path;
    std::string m_file;
    bool m_isOld = false;           ///< of 3D Slicer 4, which wrote models in RAS without saying so
    std::vector<MrmlNode> m_shapes; ///< models and segmentations, in the order of the file
    std::map<std::string, MrmlNode> m_nodes;
    Blocks m_out;
};

/// Collects the nodes of the scene itself; scene views contain copies of nodes.
Status MrmlReader::readNodes()
{
    if (m_xml.readNextStartElement()) {
        m_isOld = m_xml.attributes().value(QLatin1String("version")).startsWith(QLatin1String("Slicer4"));
        while (m_xml.readNextStartElement()) {
            MrmlNode node;
            node.kind = m_xml.name().toString().toStdString();
            for (const QXmlStreamAttribute& attribute : m_xml.attributes()) {
                node.attributes.emplace(attribute.name().toString().toStdString(),
                                        attribute.value().toString().toStdString());
            }
            if (node.kind == "Model" || node.kind == "Segmentation") {
                m_shapes.push_back(node);
            }
            m_nodes.emplace(node.at("id"), std::move(node));
            m_xml.skipCurrentElement();
        }
    }
    if (m_xml.hasError()) {
        return fault(StatusCode::BadFormat, m_file, onLine(static_cast<std::uint64_t>(m_xml.lineNumber())),
                     {PALPATE_TEXT("the XML is broken: %1"), inQuotes(m_xml.errorString().toStdString())},
                     {PALPATE_TEXT("well-formed XML to the end of the file")});
    }
    return {};
}

/// @return the file of a model; empty for one in another folder tree. A file of an absolute path is looked for beside
/// the scene: the folder may have been moved.
std::optional<fs::path> MrmlReader::fileOf(const MrmlNode& storage) const
{
    const QByteArray stored = QByteArray::fromStdString(storage.at("fileName"));
    const std::string decoded = withSlashes(QUrl::fromPercentEncoding(stored).toStdString());
    const fs::path name = fs::path(decoded).lexically_normal();
    const bool isOfWindows = decoded.size() > 2 && decoded[1] == ':' && decoded[2] == '/'; // "C:/…"
    if (name.empty() || !name.has_filename() || *name.begin() == "..") {
        return std::nullopt;
    }
    return m_path.parent_path() / (name.is_absolute() || isOfWindows ? name.filename() : name);
}

/// Multiplies the transforms above a node. @return false for one that is not linear, or that changes angles
bool MrmlReader::setTransform(const MrmlNode& node, Block& block) const
{
    constexpr int kDeepest = 64;
    constexpr double kAngle = 1e-6; ///< deviation from a rotation
    Eigen::Affine3d toWorld = Eigen::Affine3d::Identity();
    const MrmlNode* below = &node;
    for (int depth = 0;; ++depth) {
        const std::string id = below->reference("transform");
        const MrmlNode* const transform = find(id);
        if (id.empty()) {
            break;
        }
        const auto numbers =
            transform == nullptr ? std::nullopt : numbersOf<16>(transform->at("matrixTransformToParent"));
        if (!numbers || depth == kDeepest) {
            return false;
        }
        const Eigen::Affine3d toParent(
            Eigen::Matrix4d(Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers->data())));
        toWorld = toParent * toWorld;
        below = transform;
    }
    const double scale = std::cbrt(toWorld.linear().determinant());
    const Eigen::Matrix3d rotation = toWorld.linear() / scale;
    if (!(scale > kAngle && scale < 1.0 / kAngle) ||
        !((rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).norm() < kAngle) ||
        !(toWorld.translation().norm() < kMostMm)) {
        return false;
    }
    // MRML's matrices are in RAS.
    const Eigen::Matrix3d turned = core::lpsRotation(core::FileFrame::Ras);
    block.unit_mm = std::abs(scale - 1.0) < kAngle ? 1.0 : scale;
    block.X_WM.linear() = turned * rotation * turned.transpose();
    block.X_WM.translation() = turned * toWorld.translation();
    return true;
}

void MrmlReader::addBlock(const MrmlNode& node)
{
    const MrmlNode* const storage = find(node.reference("storage"));
    const MrmlNode* const display = find(node.reference("display"));
    Block block;
    block.name = node.at("name");
    const auto lose = [&](const core::Message& why) {
        m_out.losses.push_back({PALPATE_TEXT("%1: %2 is not opened: %3"), m_file, inQuotes(block.name), why});
    };
    if (storage == nullptr || storage->at("fileName").empty()) {
        const bool isInternal = node.at("hideFromEditors") == "true" || node.at("hideFromEditors") == "1";
        if (!isInternal) { // 3D Slicer keeps the planes of the slices as hidden models
            lose({PALPATE_TEXT("the scene names no file of it")});
        }
        return;
    }
    const std::optional<fs::path> file = fileOf(*storage);
    if (!file) {
        lose({PALPATE_TEXT("the file %1 is not in the folder of the scene"), inQuotes(storage->at("fileName"))});
        return;
    }
    if (!setTransform(node, block)) {
        lose({PALPATE_TEXT("its transform is not a rotation, shift and scale: harden it in 3D Slicer")});
        return;
    }
    block.file = *file;
    if (node.kind == "Model") {
        const std::string system = storage->at("coordinateSystem");
        block.frame = system == "RAS" || (system.empty() && m_isOld) ? core::FileFrame::Ras
                      : system == "LPS"                              ? core::FileFrame::Lps
                                                                     : core::FileFrame::Untagged;
        const auto isShare = [](double value) { return value >= 0.0 && value <= 1.0; };
        if (display != nullptr) {
            const auto colour = numbersOf<3>(display->at("color"));
            if (colour && isShare((*colour)[0]) && isShare((*colour)[1]) && isShare((*colour)[2])) {
                block.colour = colour;
            }
            const auto opacity = numbersOf<1>(display->at("opacity"));
            block.opacity = opacity && isShare((*opacity)[0]) ? (*opacity)[0] : 1.0;
            block.isVisible = display->at("visibility") != "false" && display->at("visibility") != "0";
        }
    }
    m_out.blocks.push_back(std::move(block));
}

Result<Blocks> MrmlReader::run()
{
    if (Status status = readNodes(); !status.isOk()) {
        return status;
    }
    for (const MrmlNode& node : m_shapes) {
        addBlock(node);
    }
    if (m_out.blocks.empty()) {
        return m_out.losses.empty()
                   ? fault(StatusCode::Empty, m_file, {}, {PALPATE_TEXT("a scene without models and segmentations")},
                           {PALPATE_TEXT("at least one (3D Slicer: File, Save Data)")})
                   : Status(StatusCode::Empty, m_out.losses.front());
    }
    return std::move(m_out);
}

} // namespace

Result<Blocks> readMrml(std::string_view bytes, const fs::path& path)
{
    return MrmlReader(bytes, path).run();
}

} // namespace palpate::meshio::internal
