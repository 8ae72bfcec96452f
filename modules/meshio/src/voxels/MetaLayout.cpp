// SPDX-License-Identifier: BSD-3-Clause
// Source of the format: https://itk.org/Wiki/ITK/MetaIO/Documentation; places and directions are in LPS, as ITK writes
// them.
#include "text/TextScan.h"
#include "voxels/VolumeLayout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace palpate::meshio::internal {

namespace {

using core::Message;
using core::Result;
using core::Status;
using core::StatusCode;
using core::Vec3;

constexpr std::size_t kMostMetaHeader = 65536; ///< [bytes]

/// @return true for "LIST", which the number of dimensions of each file may follow
bool isFileList(const std::string& text)
{
    return text == "LIST" || text == "LIST 2" || text == "LIST 3";
}

/// Parses one header, which ends with ElementDataFile.
class MetaParser
{
  public:
    MetaParser(std::string_view bytes, const std::string& file)
        : m_bytes(bytes)
        , m_file(file)
    {
    }

    Result<VolumeLayout> parse()
    {
        m_layout.format = "MetaImage";
        m_layout.frame = core::FileFrame::Lps;
        for (const auto step : {&MetaParser::takeFields, &MetaParser::takeSizes, &MetaParser::takeNumbers,
                                &MetaParser::takeAxes, &MetaParser::takeDataFiles}) {
            if (Status status = (this->*step)(); !status.isOk()) {
                return status;
            }
        }
        if (Status status = checkLayout(m_layout, m_file); !status.isOk()) {
            return status;
        }
        return std::move(m_layout);
    }

  private:
    /// @return value of the first of these fields that is present
    [[nodiscard]] std::string value(std::initializer_list<const char*> names) const
    {
        for (const char* name : names) {
            if (const auto found = m_fields.find(name); found != m_fields.end()) {
                return found->second;
            }
        }
        return {};
    }
    [[nodiscard]] bool isTrue(std::initializer_list<const char*> names) const
    {
        const std::string text = value(names);
        return !text.empty() && std::string_view("Tt1").find(text[0]) != std::string_view::npos;
    }
    [[nodiscard]] Status wrong(const char* field, const Message& expected,
                               StatusCode code = StatusCode::BadFormat) const
    {
        return fault(code, m_file, Message(PALPATE_TEXT("header: %1"), field),
                     Message(PALPATE_TEXT("%1"), inQuotes(value({field}))), expected);
    }
    Status takeFields();
    Status takeSizes();
    Status takeNumbers();
    Status takeAxes();
    Status takeDataFiles();

    std::string_view m_bytes;
    const std::string& m_file;
    std::map<std::string, std::string> m_fields;
    std::vector<std::string> m_list; ///< lines after "ElementDataFile = LIST"
    VolumeLayout m_layout;
};

Status MetaParser::takeFields()
{
    LineReader lines(m_bytes.substr(0, kMostMetaHeader));
    bool isList = false;
    while (lines.next()) {
        const std::string_view line = trimmed(lines.line());
        if (line.find('\0') != std::string_view::npos) {
            return fault(StatusCode::BadFormat, m_file, onLine(lines.number()),
                         Message(PALPATE_TEXT("a byte of 0 in the header")), Message(PALPATE_TEXT("text")));
        }
        m_layout.offset = lines.end();
        const std::size_t separator = line.find('=');
        if (isList) {
            if (!line.empty()) {
                m_list.emplace_back(line);
            }
            continue;
        }
        if (separator == std::string_view::npos) {
            continue; // MetaIO skips such lines, too
        }
        const std::string key(trimmed(line.substr(0, separator)));
        const std::string text(trimmed(line.substr(separator + 1)));
        if (!m_fields.emplace(key, text).second && key != "Comment") {
            return fault(StatusCode::BadFormat, m_file, onLine(lines.number()),
                         Message(PALPATE_TEXT("%1 a second time"), inQuotes(key)),
                         Message(PALPATE_TEXT("each field once")));
        }
        if (key == "ElementDataFile") { // the last field
            isList = isFileList(text);
            if (!isList) {
                return {};
            }
        }
    }
    if (!isList) {
        return fault(
            StatusCode::BadFormat, m_file, Message(PALPATE_TEXT("header")),
            Message(PALPATE_TEXT("the header does not end")),
            Message(PALPATE_TEXT("a line with ElementDataFile, within %1 bytes"), core::Count(kMostMetaHeader)));
    }
    return {};
}

Status MetaParser::takeSizes()
{
    const std::vector<double> axes = numbersIn(value({"NDims"}), 1);
    if (axes.size() != 1 || (axes[0] != 3.0 && axes[0] != 4.0)) {
        return wrong("NDims", Message(PALPATE_TEXT("3 or 4")), StatusCode::Unsupported);
    }
    const std::vector<double> sizes = numbersIn(value({"DimSize"}), 4);
    if (sizes.size() != static_cast<std::size_t>(axes[0]) || !std::all_of(sizes.begin(), sizes.end(), [](double size) {
            return size >= 1.0 && size <= kMostAlong && size == std::floor(size);
        })) {
        return wrong("DimSize", Message(PALPATE_TEXT("a count from 1 to %1 for each of %2 axes"),
                                        core::Count(kMostAlong), axes[0]));
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        m_layout.size[axis] = static_cast<std::uint32_t>(sizes[axis]);
    }
    m_layout.layers = sizes.size() == 4 ? static_cast<std::uint32_t>(sizes[3]) : 1;
    if (const std::string channels = value({"ElementNumberOfChannels"}); !channels.empty()) {
        const std::vector<double> count = numbersIn(channels, 1);
        if (count.size() != 1 || !(count[0] >= 1.0 && count[0] <= kMostAlong) || count[0] != std::floor(count[0]) ||
            (count[0] != 1.0 && m_layout.layers != 1)) {
            return wrong("ElementNumberOfChannels", Message(PALPATE_TEXT("1")), StatusCode::Unsupported);
        }
        if (count[0] != 1.0) {
            m_layout.layers = static_cast<std::uint32_t>(count[0]);
            m_layout.isInterleaved = true;
            m_layout.isVector = true;
        }
    }
    return {};
}

Status MetaParser::takeNumbers()
{
    static constexpr auto kTypes =
        std::to_array<std::pair<std::string_view, VoxelType>>({{"MET_CHAR", VoxelType::Int8},
                                                               {"MET_UCHAR", VoxelType::UInt8},
                                                               {"MET_SHORT", VoxelType::Int16},
                                                               {"MET_USHORT", VoxelType::UInt16},
                                                               {"MET_INT", VoxelType::Int32},
                                                               {"MET_UINT", VoxelType::UInt32},
                                                               {"MET_LONG", VoxelType::Int32},
                                                               {"MET_ULONG", VoxelType::UInt32},
                                                               {"MET_LONG_LONG", VoxelType::Int64},
                                                               {"MET_ULONG_LONG", VoxelType::UInt64},
                                                               {"MET_FLOAT", VoxelType::Float32},
                                                               {"MET_DOUBLE", VoxelType::Float64}});
    const std::string name = value({"ElementType"});
    const auto* const type =
        std::find_if(kTypes.begin(), kTypes.end(), [&](const auto& one) { return one.first == name; });
    if (type == kTypes.end()) {
        return wrong("ElementType", Message(PALPATE_TEXT("a type of number, as MET_UCHAR or MET_SHORT")),
                     StatusCode::Unsupported);
    }
    m_layout.type = type->second;
    if (!isTrue({"BinaryData"})) {
        return wrong("BinaryData", Message(PALPATE_TEXT("True: voxels as binary numbers")), StatusCode::Unsupported);
    }
    m_layout.isBigEndian = isTrue({"BinaryDataByteOrderMSB", "ElementByteOrderMSB"});
    m_layout.isPacked = isTrue({"CompressedData"});
    return {};
}

Status MetaParser::takeAxes()
{
    const std::size_t axes = m_fields["NDims"] == "4" ? 4 : 3;
    std::vector<double> spacing = numbersIn(value({"ElementSpacing", "ElementSize"}), axes);
    std::vector<double> origin = numbersIn(value({"Offset", "Position", "Origin"}), axes);
    std::vector<double> matrix = numbersIn(value({"TransformMatrix", "Rotation", "Orientation"}), axes * axes);
    const auto isAbsent = [this](std::initializer_list<const char*> names) { return value(names).empty(); };
    if (isAbsent({"ElementSpacing", "ElementSize"})) {
        spacing.assign(axes, 1.0);
    }
    if (isAbsent({"Offset", "Position", "Origin"})) {
        origin.assign(axes, 0.0);
    }
    if (isAbsent({"TransformMatrix", "Rotation", "Orientation"})) {
        matrix.assign(axes * axes, 0.0);
        for (std::size_t axis = 0; axis < axes; ++axis) {
            matrix[axis * (axes + 1)] = 1.0;
        }
    }
    if (spacing.size() != axes) {
        return wrong("ElementSpacing", Message(PALPATE_TEXT("%1 numbers"), axes));
    }
    if (origin.size() != axes) {
        return wrong("Offset", Message(PALPATE_TEXT("%1 numbers"), axes));
    }
    if (matrix.size() != axes * axes) {
        return wrong("TransformMatrix", Message(PALPATE_TEXT("%1 numbers"), axes * axes));
    }
    for (std::size_t axis = 0; axis < 3; ++axis) { // each row of the text is the direction of one axis
        const auto column = static_cast<Eigen::Index>(axis);
        m_layout.steps.col(column) =
            spacing[axis] * Vec3(matrix[axis * axes], matrix[axis * axes + 1], matrix[axis * axes + 2]);
        m_layout.origin[column] = origin[axis];
    }
    return {};
}

Status MetaParser::takeDataFiles()
{
    const std::string name = value({"ElementDataFile"});
    const bool isLocal = name == "LOCAL" || name == "Local" || name == "local";
    m_layout.offset = isLocal ? m_layout.offset : 0;
    if (const std::string skipped = value({"HeaderSize"}); !skipped.empty() && skipped != "0") {
        const std::optional<std::int64_t> bytes = wordToInteger(skipped); // from the beginning of the file
        if (m_layout.isPacked || !bytes || *bytes < -1 ||
            (*bytes >= 0 && static_cast<std::uint64_t>(*bytes) < m_layout.offset)) {
            return wrong("HeaderSize",
                         Message(PALPATE_TEXT("0, or the bytes before uncompressed voxels, or -1 if the "
                                              "voxels end with their file")),
                         StatusCode::Unsupported);
        }
        m_layout.isAtEnd = *bytes < 0;
        m_layout.offset = m_layout.isAtEnd ? m_layout.offset : static_cast<std::uint64_t>(*bytes);
    }
    if (isLocal) {
        return {};
    }
    const bool isList = isFileList(name);
    if (name.empty() || (isList && (m_layout.isPacked || m_list.empty()))) {
        return wrong("ElementDataFile", Message(PALPATE_TEXT("one file, or uncompressed files in a LIST")),
                     StatusCode::Unsupported);
    }
    if (!isList && name.find('%') != std::string::npos) {
        return wrong("ElementDataFile",
                     Message(PALPATE_TEXT("the name of one file, or LIST and one name on each line")),
                     StatusCode::Unsupported);
    }
    m_layout.dataFiles = isList ? m_list : std::vector<std::string>{name};
    return {};
}

} // namespace

bool looksLikeMetaImage(std::string_view bytes)
{
    LineReader lines(bytes.substr(0, 4096));
    constexpr int kMostLines = 16;
    for (int line = 0; line < kMostLines && lines.next(); ++line) {
        const std::string_view text = trimmed(lines.line());
        const std::size_t separator = text.find('=');
        if (separator == std::string_view::npos) {
            return false;
        }
        const std::string_view key = trimmed(text.substr(0, separator));
        if (key == "NDims") {
            return true;
        }
    }
    return false;
}

Result<VolumeLayout> metaLayout(std::string_view bytes, const std::string& file)
{
    return MetaParser(bytes, file).parse();
}

} // namespace palpate::meshio::internal
