// SPDX-License-Identifier: BSD-3-Clause
// Source of the format: https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html
#include "formats/VtiVolume.h"

#include "formats/VtpBlocks.h"
#include "formats/VtpHeader.h"
#include "text/TextScan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace palpate::meshio::internal {

namespace {

using core::Message;
using core::Result;
using core::Status;
using core::StatusCode;
using core::Vec3;

/// First and last voxel along each axis.
using Extent = std::array<std::int64_t, 6>;

std::optional<Extent> extentOf(std::string_view text)
{
    Extent extent{};
    for (std::int64_t& bound : extent) {
        const std::optional<std::int64_t> number = wordToInteger(takeWord(text));
        constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max(); // as in VTK
        if (!number || *number < -kMost || *number > kMost) {
            return std::nullopt;
        }
        bound = *number;
    }
    return trimmed(text).empty() ? std::optional(extent) : std::nullopt;
}

/// Reads the array of one piece after the other into the whole image.
class VtiReader
{
  public:
    /// @param bytes  of the file
    VtiReader(const VtpHeader& header, std::uint64_t bytes, const ScanContext& context)
        : m_header(header)
        , m_bytes(bytes)
        , m_context(context)
    {
    }
    Result<VtiVolume> run();

  private:
    [[nodiscard]] Status wrong(const Message& place, const Message& found, const Message& expected,
                               StatusCode code = StatusCode::BadFormat) const
    {
        return fault(code, m_context.file, place, found, expected);
    }
    /// Reads `count` numbers from an attribute. @return an error for anything else; `missing` if it is absent
    [[nodiscard]] Result<std::vector<double>> numbers(const char* name, const std::string& text, std::size_t count,
                                                      std::vector<double> missing) const;
    Status takeGrid();
    /// Finds the extents of the pieces and checks that they can cover the whole with the bytes of the file.
    Status takeExtents();
    /// Finds the array of a piece: the only one, or the one that is marked.
    [[nodiscard]] Result<const VtpDataArray*> arrayOf(const VtpPiece& piece) const;
    Status takeNumbers(const VtpDataArray& array, const Extent& extent);
    Status takeText(const VtpDataArray& array, const Extent& extent, std::uint64_t count);
    /// Stores the numbers of a piece from its voxel `at` on.
    void store(const Extent& extent, std::uint64_t at, std::span<const double> numbers);

    const VtpHeader& m_header;
    std::uint64_t m_bytes;
    const ScanContext& m_context;
    bool m_isOfCells = false;
    Extent m_whole{};
    std::vector<std::pair<const VtpPiece*, Extent>> m_pieces; ///< with their extents in voxels, without empty ones
    VtiVolume m_volume;
    std::vector<bool> m_isKnown; ///< voxels with a number, if there are several pieces
};

Result<std::vector<double>> VtiReader::numbers(const char* name, const std::string& text, std::size_t count,
                                               std::vector<double> missing) const
{
    if (text.empty()) {
        return missing;
    }
    std::vector<double> found = numbersIn(text, count);
    return found.size() == count ? Result<std::vector<double>>(std::move(found))
                                 : wrong({PALPATE_TEXT("header: %1"), name}, {PALPATE_TEXT("%1"), inQuotes(text)},
                                         {PALPATE_TEXT("%1 finite numbers"), count});
}

Status VtiReader::takeGrid()
{
    const VtpImage& image = m_header.image;
    const std::optional<Extent> whole = extentOf(image.extent);
    m_isOfCells = std::all_of(m_header.pieces.begin(), m_header.pieces.end(),
                              [](const VtpPiece& piece) { return piece.pointData.empty(); }) &&
                  std::any_of(m_header.pieces.begin(), m_header.pieces.end(),
                              [](const VtpPiece& piece) { return !piece.cellData.empty(); });
    VolumeLayout& layout = m_volume.layout;
    layout.format = "VTI";
    for (std::size_t axis = 0; axis < 3 && whole; ++axis) {
        const std::int64_t count = (*whole)[2 * axis + 1] - (*whole)[2 * axis] + (m_isOfCells ? 0 : 1);
        layout.size[axis] =
            count < 1 || count > static_cast<std::int64_t>(kMostAlong) ? 0 : static_cast<std::uint32_t>(count);
    }
    if (!whole || std::any_of(layout.size.begin(), layout.size.end(), [](std::uint32_t along) { return along == 0; })) {
        return wrong({PALPATE_TEXT("header: %1"), "WholeExtent"}, {PALPATE_TEXT("%1"), inQuotes(image.extent)},
                     {PALPATE_TEXT("the first and last number of a voxel along each axis, at most %1 apart"),
                      core::Count(kMostAlong)},
                     StatusCode::OutOfRange);
    }
    m_whole = *whole;
    const Result<std::vector<double>> origin = numbers("Origin", image.origin, 3, {0, 0, 0}),
                                      spacing = numbers("Spacing", image.spacing, 3, {1, 1, 1}),
                                      direction = numbers("Direction", image.direction, 9, {1, 0, 0, 0, 1, 0, 0, 0, 1});
    for (const auto* read : {&origin, &spacing, &direction}) {
        if (!read->isOk()) {
            return read->status();
        }
    }
    const Eigen::Matrix3d directions =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(direction.value().data());
    const Vec3 first(static_cast<double>(m_whole[0]), static_cast<double>(m_whole[2]), static_cast<double>(m_whole[4]));
    layout.steps = directions * Vec3(spacing.value().data()).asDiagonal();
    layout.origin = Vec3(origin.value().data()) + layout.steps * (first + Vec3::Constant(m_isOfCells ? 0.5 : 0.0));
    return checkLayout(layout, m_context.file);
}

Result<const VtpDataArray*> VtiReader::arrayOf(const VtpPiece& piece) const
{
    const std::vector<VtpDataArray>& arrays = m_isOfCells ? piece.cellData : piece.pointData;
    const auto marked = std::find_if(arrays.begin(), arrays.end(),
                                     [&piece](const VtpDataArray& array) { return array.name == piece.scalars; });
    const VtpDataArray* array = marked != arrays.end() ? &*marked : arrays.size() == 1 ? &arrays.front() : nullptr;
    const Message expected(PALPATE_TEXT("one number for each voxel"));
    if (array == nullptr) {
        return wrong(onLine(piece.line),
                     arrays.empty() ? Message(PALPATE_TEXT("no numbers"))
                                    : Message(PALPATE_TEXT("%1 arrays, none of them marked as the scalars"),
                                              core::Count(arrays.size())),
                     expected);
    }
    if (array->components != 1) {
        return wrong(onLine(array->line), {PALPATE_TEXT("%1 components per voxel"), core::Count(array->components)},
                     expected);
    }
    if (vtpTypeSize(array->type) == 0) {
        return wrong(onLine(array->line), {PALPATE_TEXT("numbers of type %1"), inQuotes(array->type)}, expected);
    }
    return array;
}

void VtiReader::store(const Extent& extent, std::uint64_t at, std::span<const double> numbers)
{
    if (m_volume.values.empty()) { // only now is it certain that the file has numbers for its first piece
        m_volume.values.resize(m_volume.layout.voxels());
    }
    const auto& size = m_volume.layout.size;
    const auto across = static_cast<std::uint64_t>(extent[1] - extent[0] + 1),
               along = static_cast<std::uint64_t>(extent[3] - extent[2] + 1);
    for (const double number : numbers) {
        const std::uint64_t x = at % across + static_cast<std::uint64_t>(extent[0] - m_whole[0]),
                            y = at / across % along + static_cast<std::uint64_t>(extent[2] - m_whole[2]),
                            z = at / across / along + static_cast<std::uint64_t>(extent[4] - m_whole[4]);
        const std::uint64_t voxel = x + size[0] * (y + size[1] * z);
        m_volume.values[voxel] = static_cast<float>(number);
        if (!m_isKnown.empty()) {
            m_isKnown[voxel] = true;
        }
        ++at;
    }
}

Status VtiReader::takeText(const VtpDataArray& array, const Extent& extent, std::uint64_t count)
{
    std::string_view rest(array.text.constData(), static_cast<std::size_t>(array.text.size()));
    std::vector<double> found;
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
        const std::optional<double> number = wordToNumber(word);
        if (!number) {
            return wrong(onLine(array.line), {PALPATE_TEXT("array %1: %2"), inQuotes(array.name), inQuotes(word)},
                         {PALPATE_TEXT("one number for each voxel")});
        }
        found.push_back(*number);
    }
    if (found.size() != count) {
        return wrong(onLine(array.line),
                     {PALPATE_TEXT("%1 numbers for %2 voxels"), core::Count(found.size()), core::Count(count)},
                     {PALPATE_TEXT("one number for each voxel")});
    }
    store(extent, 0, found);
    return {};
}

Status VtiReader::takeNumbers(const VtpDataArray& array, const Extent& extent)
{
    std::uint64_t count = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        count *= static_cast<std::uint64_t>(extent[2 * axis + 1] - extent[2 * axis] + 1);
    }
    if (array.format == VtpFormat::Ascii) {
        return takeText(array, extent, count);
    }
    const Result<VtpBlocks> blocks = VtpBlocks::find(array, m_header, m_context);
    if (!blocks.isOk()) {
        return blocks.status();
    }
    const std::uint64_t each = vtpTypeSize(array.type);
    if (blocks.value().size() != count * each) {
        return wrong(onLine(array.line),
                     {PALPATE_TEXT("array %1: %2"), inQuotes(array.name),
                      Message(PALPATE_TEXT("%1 bytes"), core::Count(blocks.value().size()))},
                     {PALPATE_TEXT("%1 bytes of voxels"), core::Count(count * each)});
    }
    const auto bytes = blocks.value().unpack();
    if (!bytes) {
        return wrong(onLine(array.line),
                     {PALPATE_TEXT("array %1: %2"), inQuotes(array.name),
                      Message(PALPATE_TEXT("its compressed data are damaged"))},
                     {PALPATE_TEXT("data that can be decompressed")});
    }
    constexpr std::uint64_t kBlock = std::uint64_t{1} << 16; // voxels
    const std::span<const unsigned char> all(*bytes);
    for (std::uint64_t at = 0; at < count; at += kBlock) {
        const std::uint64_t some = std::min(kBlock, count - at);
        store(extent, at, vtpNumbers(all.subspan(at * each, some * each), array.type, m_header.isBigEndian));
        if (m_context.progress && !m_context.progress(static_cast<double>(at) / static_cast<double>(count))) {
            return {StatusCode::Cancelled, PALPATE_TEXT("%1: reading was cancelled"), m_context.file};
        }
    }
    return {};
}

Status VtiReader::takeExtents()
{
    const std::uint64_t voxels = m_volume.layout.voxels();
    std::uint64_t inPieces = 0;
    for (const VtpPiece& piece : m_header.pieces) {
        std::optional<Extent> extent = piece.extent.empty() ? m_whole : extentOf(piece.extent);
        if (extent && ((*extent)[1] < (*extent)[0] || (*extent)[3] < (*extent)[2] || (*extent)[5] < (*extent)[4])) {
            continue;
        }
        std::uint64_t count = 1;
        for (std::size_t axis = 0; axis < 3 && extent; ++axis) {
            Extent& found = *extent;
            if (found[2 * axis] < m_whole[2 * axis] || found[2 * axis + 1] > m_whole[2 * axis + 1]) {
                extent.reset();
                break;
            }
            found[2 * axis + 1] -= m_isOfCells ? 1 : 0; // the last cell
            count *= static_cast<std::uint64_t>(found[2 * axis + 1] - found[2 * axis] + 1);
        }
        if (!extent) {
            return wrong(onLine(piece.line), {PALPATE_TEXT("found %1=%2"), "Extent", inQuotes(piece.extent)},
                         {PALPATE_TEXT("a part of the whole, %1"), inQuotes(m_header.image.extent)});
        }
        m_pieces.emplace_back(&piece, *extent);
        inPieces += std::min(count, voxels);
    }
    constexpr std::uint64_t kMostShared = 8; // pieces share the voxels at their borders
    if (inPieces > kMostShared * voxels) {
        return wrong({}, {PALPATE_TEXT("%1 numbers for %2 voxels"), core::Count(inPieces), core::Count(voxels)},
                     {PALPATE_TEXT("pieces that cover the whole extent once")});
    }
    if (inPieces < voxels) {
        return wrong({}, {PALPATE_TEXT("%1 numbers for %2 voxels"), core::Count(inPieces), core::Count(voxels)},
                     {PALPATE_TEXT("pieces that cover the whole extent")});
    }
    constexpr std::uint64_t kMostPacked = 8000; // bytes that LZMA can make of one
    if (voxels > m_bytes * (m_header.compressor == VtpCompressor::None ? 1 : kMostPacked)) {
        return wrong({}, {PALPATE_TEXT("%1 voxels declared"), core::Count(voxels)},
                     {PALPATE_TEXT("as many as its %1 bytes can hold"), core::Count(m_bytes)}, StatusCode::OutOfRange);
    }
    return {};
}

Result<VtiVolume> VtiReader::run()
{
    for (const auto step : {&VtiReader::takeGrid, &VtiReader::takeExtents}) {
        if (Status status = (this->*step)(); !status.isOk()) {
            return status;
        }
    }
    const std::uint64_t voxels = m_volume.layout.voxels();
    m_isKnown.resize(m_pieces.size() > 1 ? voxels : 0);
    for (const auto& [piece, extent] : m_pieces) {
        const Result<const VtpDataArray*> array = arrayOf(*piece);
        Status status = array.isOk() ? takeNumbers(*array.value(), extent) : array.status();
        if (!status.isOk()) {
            return status;
        }
    }
    const auto known = static_cast<std::uint64_t>(std::count(m_isKnown.begin(), m_isKnown.end(), true));
    if (!m_isKnown.empty() && known != voxels) {
        return wrong({}, {PALPATE_TEXT("%1 numbers for %2 voxels"), core::Count(known), core::Count(voxels)},
                     {PALPATE_TEXT("pieces that cover the whole extent")});
    }
    return std::move(m_volume);
}

} // namespace

bool looksLikeVti(std::string_view bytes)
{
    return startOfText(bytes).starts_with('<');
}

Result<VtiVolume> vtiVolume(std::string_view bytes, const std::string& file,
                            const std::function<bool(double)>& progress)
{
    ScanContext context;
    context.file = file;
    context.progress = progress;
    const Result<VtpHeader> header = readVtpHeader(bytes, context, kImageType);
    return header.isOk() ? VtiReader(header.value(), bytes.size(), context).run() : header.status();
}

} // namespace palpate::meshio::internal
