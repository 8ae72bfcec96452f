// SPDX-License-Identifier: BSD-3-Clause
#include "scene/BlockFile.h"

#include "guard/FileImage.h"
#include "text/Encoding.h"
#include "text/Fault.h"
#include "text/TextScan.h"

#include <QXmlStreamReader>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string_view>
#include <utility>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;
namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = std::size_t{4} << 20U;
constexpr std::size_t kMostOfScene = std::size_t{64} << 20U; ///< scenes of 3D Slicer hold tables too
constexpr std::size_t kMostBlocks = 4096;

class BlockReader
{
  public:
    BlockReader(const FileImage& image, const fs::path& path)
        : m_xml(QByteArray::fromRawData(image.bytes().data(), static_cast<qsizetype>(image.bytes().size())))
        , m_path(path)
        , m_file(utf8Of(path.filename().string()))
    {
    }
    Result<Blocks> run();

  private:
    Status wrong(StatusCode code, const core::Message& found, const core::Message& expected) const
    {
        return fault(code, m_file, onLine(static_cast<std::uint64_t>(m_xml.lineNumber())), found, expected);
    }
    [[nodiscard]] std::string attribute(const char* name) const
    {
        return m_xml.attributes().value(QLatin1String(name)).toString().toStdString();
    }
    Status startElement();

    QXmlStreamReader m_xml;
    fs::path m_path;
    std::string m_file;
    std::vector<std::string> m_names; ///< of the open elements
    std::vector<Block> m_blocks;
    std::set<std::string> m_steps; ///< times of a collection
};

/// Blocks may be nested; a block without a name of its own has the name of the block around it.
Status BlockReader::startElement()
{
    const std::string outer = m_names.empty() ? std::string() : m_names.back();
    const std::string own = attribute("name");
    m_names.push_back(own.empty() ? outer : own);
    if (m_xml.name() != QLatin1String("DataSet")) {
        return {};
    }
    if (attribute("file").empty()) { // an empty block
        return {};
    }
    const fs::path name = fs::path(withSlashes(attribute("file"))).lexically_normal();
    if (name.is_absolute() || *name.begin() == "..") {
        return wrong(StatusCode::Unsupported, {PALPATE_TEXT("the file name %1"), inQuotes(attribute("file"))},
                     {PALPATE_TEXT("a file in this folder or below it")});
    }
    if (m_blocks.size() >= kMostBlocks) {
        return wrong(StatusCode::OutOfRange, {PALPATE_TEXT("more than %1 files"), Count(kMostBlocks)},
                     {PALPATE_TEXT("at most %1"), Count(kMostBlocks)});
    }
    if (const std::string step = attribute("timestep"); !step.empty()) {
        m_steps.insert(step);
    }
    m_blocks.push_back({.file = m_path.parent_path() / name, .name = m_names.back()});
    return {};
}

Result<Blocks> BlockReader::run()
{
    constexpr std::size_t kDeepest = 64;
    while (!m_xml.atEnd()) {
        const auto token = m_xml.readNext();
        if (token == QXmlStreamReader::DTD || token == QXmlStreamReader::EntityReference) {
            return wrong(StatusCode::BadFormat, {PALPATE_TEXT("found a document type or an entity")},
                         {PALPATE_TEXT("a VTK file without either")});
        }
        if (token == QXmlStreamReader::StartElement) {
            if (Status status = startElement(); !status.isOk()) {
                return status;
            }
        } else if (token == QXmlStreamReader::EndElement && !m_names.empty()) {
            m_names.pop_back();
        }
        if (m_names.size() > kDeepest) {
            return wrong(StatusCode::BadFormat, {PALPATE_TEXT("elements nested in more than %1 levels"), kDeepest},
                         {PALPATE_TEXT("at most %1"), kDeepest});
        }
    }
    if (m_xml.hasError()) {
        return wrong(StatusCode::BadFormat,
                     {PALPATE_TEXT("the XML is broken: %1"), inQuotes(m_xml.errorString().toStdString())},
                     {PALPATE_TEXT("well-formed XML to the end of the file")});
    }
    if (m_steps.size() > 1) {
        return fault(StatusCode::Unsupported, m_file, {}, {PALPATE_TEXT("a series of %1 time steps"), m_steps.size()},
                     {PALPATE_TEXT("one time step: open the file of that step")});
    }
    if (m_blocks.empty()) {
        return fault(StatusCode::Empty, m_file, {}, {PALPATE_TEXT("it names no files")},
                     {PALPATE_TEXT("at least one element %1"), "\"DataSet\""});
    }
    return Blocks{std::move(m_blocks), {}};
}

bool isMrml(const fs::path& path)
{
    return sameWord(path.extension().string(), ".mrml");
}

} // namespace

bool isBlockFile(const fs::path& path)
{
    const std::string extension = path.extension().string();
    constexpr std::array<std::string_view, 5> kExtensions{".vtm", ".pvd", ".vtpd", ".vtpc", ".mrml"};
    return std::any_of(kExtensions.begin(), kExtensions.end(),
                       [&extension](std::string_view known) { return sameWord(extension, known); });
}

namespace {

Result<Blocks> readOne(const fs::path& path)
{
    const Result<OpenFile> file = openFile(path);
    if (!file.isOk()) {
        return file.status();
    }
    const std::size_t most = isMrml(path) ? kMostOfScene : kMostBytes;
    if (file.value().size > most) {
        return fault(StatusCode::OutOfRange, utf8Of(path.filename().string()), {},
                     {PALPATE_TEXT("%1 bytes"), Count(file.value().size)},
                     {PALPATE_TEXT("at most %1 bytes"), Count(most)});
    }
    const Result<FileImage> image = FileImage::load(file.value(), utf8Of(path.filename().string()));
    if (!image.isOk()) {
        return image.status();
    }
    return isMrml(path) ? readMrml(image.value().bytes(), path) : BlockReader(image.value(), path).run();
}

/// Replaces the block files among the blocks by their blocks, each file once: a file may name itself.
/// @param read   files that are open or were read
/// @param depth  of the files that led to these
void expand(Blocks& blocks, std::set<fs::path>& read, int depth)
{
    constexpr int kDeepest = 8;
    std::vector<Block> all;
    for (Block& block : blocks.blocks) {
        if (!isBlockFile(block.file) || isMrml(block.file)) {
            all.push_back(std::move(block));
            continue;
        }
        if (!read.insert(block.file.lexically_normal()).second) {
            continue;
        }
        const std::string file = utf8Of(block.file.filename().string());
        if (depth >= kDeepest || read.size() > kMostBlocks) {
            blocks.losses.push_back(
                fault(StatusCode::OutOfRange, file, {},
                      {PALPATE_TEXT("a file in more than %1 levels or behind %2 files"), kDeepest, Count(kMostBlocks)},
                      {PALPATE_TEXT("fewer files that name others")})
                    .text());
            break;
        }
        const Result<Blocks> inner = readOne(block.file);
        if (!inner.isOk()) {
            blocks.losses.push_back(inner.status().text());
            continue;
        }
        Blocks found = inner.value();
        expand(found, read, depth + 1);
        blocks.losses.insert(blocks.losses.end(), found.losses.begin(), found.losses.end());
        for (Block& one : found.blocks) {
            one.name = one.name.empty() ? block.name : one.name;
            all.push_back(std::move(one));
        }
        if (all.size() > kMostBlocks) {
            blocks.losses.push_back(fault(StatusCode::OutOfRange, file, {},
                                          {PALPATE_TEXT("more than %1 files"), Count(kMostBlocks)},
                                          {PALPATE_TEXT("at most %1"), Count(kMostBlocks)})
                                        .text());
            break;
        }
    }
    blocks.blocks = std::move(all);
}

} // namespace

std::string withSlashes(std::string path)
{
    std::replace(path.begin(), path.end(), '\\', '/');
    return path;
}

Result<Blocks> readBlocks(const fs::path& path)
{
    Result<Blocks> blocks = readOne(path);
    if (!blocks.isOk()) {
        return blocks;
    }
    Blocks out = std::move(blocks).value();
    std::set<fs::path> read{path.lexically_normal()};
    expand(out, read, 0);
    if (out.blocks.empty() && out.losses.empty()) {
        return fault(StatusCode::Empty, utf8Of(path.filename().string()), {}, {PALPATE_TEXT("it names only itself")},
                     {PALPATE_TEXT("at least one mesh file")});
    }
    std::set<std::string> used;
    for (Block& block : out.blocks) {
        const std::string plain = block.name;
        for (int number = 2; !plain.empty() && !used.insert(block.name).second; ++number) {
            block.name = plain + " " + std::to_string(number);
        }
    }
    return out;
}

} // namespace palpate::meshio::internal
