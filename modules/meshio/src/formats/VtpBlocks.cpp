// SPDX-License-Identifier: BSD-3-Clause
#include "formats/VtpBlocks.h"

#include "guard/VtkMessages.h"
#include "text/Fault.h"
#include "text/TextScan.h"

#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkSmartPointer.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;

/// Maximum compression ratio; larger declared ratios are impossible.
std::uint64_t mostRatio(VtpCompressor compressor)
{
    switch (compressor) {
    case VtpCompressor::ZLib:
        return 1100;
    case VtpCompressor::Lz4:
        return 260;
    case VtpCompressor::Lzma:
        return 8000;
    case VtpCompressor::None:
        break;
    }
    return 1;
}

int base64Value(char c)
{
    if (c >= 'A' && c <= 'Z') {
        return c - 'A';
    }
    if (c >= 'a' && c <= 'z') {
        return c - 'a' + 26;
    }
    if (c >= '0' && c <= '9') {
        return c - '0' + 52;
    }
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// Decodes up to `most` bytes from the start of a base64 stream; fewer if the stream ends earlier.
std::string fromBase64(std::string_view text, std::uint64_t most)
{
    std::string out;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const int value = base64Value(c);
        if (value < 0 || out.size() >= most) {
            break;
        }
        bits = (bits << 6) | static_cast<std::uint32_t>(value);
        count += 6;
        if (count >= 8) {
            count -= 8;
            out += static_cast<char>((bits >> count) & 0xffU);
        }
    }
    return out;
}

/// @return number of base64 characters for `bytes` bytes
std::uint64_t base64Length(std::uint64_t bytes)
{
    return (bytes + 2) / 3 * 4;
}

/// Word `i` of a block header. @pre the word is inside `data`
std::uint64_t headerWord(std::string_view data, std::uint64_t i, const VtpHeader& header)
{
    std::array<unsigned char, 8> raw = {};
    const std::size_t width = header.hasWideHeaders ? 8 : 4;
    std::memcpy(raw.data(), data.data() + i * width, width);
    if (header.isBigEndian) {
        std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(width));
    }
    return std::bit_cast<std::uint64_t>(raw);
}

} // namespace

/// Reads the header of an array's data and cuts the data into blocks.
class VtpBlockFinder
{
  public:
    VtpBlockFinder(const VtpDataArray& array, const VtpHeader& header, const ScanContext& context)
        : m_array(array)
        , m_header(header)
        , m_context(context)
        , m_isBase64(array.format != VtpFormat::Appended || header.isAppendedBase64)
        , m_width(header.hasWideHeaders ? 8 : 4)
        , m_text(trimmed({array.text.constData(), static_cast<std::size_t>(array.text.size())}))
    {
        m_blocks.m_compressor = header.compressor;
    }
    Result<VtpBlocks> run();

  private:
    Status wrong(const core::Message& found, const core::Message& expected) const
    {
        return fault(StatusCode::OutOfRange, m_context.file, onLine(m_array.line),
                     {PALPATE_TEXT("array %1: %2"), inQuotes(m_array.name), found}, expected);
    }
    Status findPlain(std::uint64_t size);
    Status findPacked(std::uint64_t count);
    /// Decodes the first `bytes` bytes of the data into m_head.
    Status readHead(std::uint64_t bytes);
    /// Checks the sizes of the blocks. @param first  offset of the first block in m_data
    Status takeBlocks(std::uint64_t count, std::uint64_t first, std::uint64_t& end);

    const VtpDataArray& m_array;
    const VtpHeader& m_header;
    const ScanContext& m_context;
    bool m_isBase64;
    std::uint64_t m_width;   ///< size of a header word [bytes]
    std::string_view m_text; ///< text of the file, from the header on
    std::string m_decoded;
    std::string_view m_head;
    VtpBlocks m_blocks;
};

Status VtpBlockFinder::readHead(std::uint64_t bytes)
{
    m_decoded = m_isBase64 ? fromBase64(m_text, bytes) : std::string();
    m_head = m_isBase64 ? m_decoded : m_text;
    return m_head.size() < bytes ? wrong({PALPATE_TEXT("the file ends in the header of its data")},
                                         {PALPATE_TEXT("%1 bytes"), Count(bytes)})
                                 : Status();
}

/// Uncompressed data: one block after a size field.
Status VtpBlockFinder::findPlain(std::uint64_t size)
{
    std::string_view data = m_text;
    if (m_isBase64) {
        if (size > m_text.size()) {
            return wrong({PALPATE_TEXT("size of its data: declared %1 bytes"), Count(size)},
                         {PALPATE_TEXT("at most %1, the number of characters that follow"), Count(m_text.size())});
        }
        m_blocks.m_decoded = std::make_shared<const std::string>(fromBase64(m_text, m_width + size));
        data = *m_blocks.m_decoded;
    }
    if (size > data.size() - m_width) {
        return wrong({PALPATE_TEXT("size of its data: declared %1 bytes"), Count(size)},
                     {PALPATE_TEXT("at most %1, the number of bytes that follow"), Count(data.size() - m_width)});
    }
    m_blocks.m_data = data;
    m_blocks.m_blocks.push_back({m_width, size, size});
    m_blocks.m_size = size;
    return {};
}

Status VtpBlockFinder::takeBlocks(std::uint64_t count, std::uint64_t first, std::uint64_t& end)
{
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max() / 4;
    const std::uint64_t blockSize = headerWord(m_head, 1, m_header);
    const std::uint64_t lastSize = headerWord(m_head, 2, m_header);
    const std::uint64_t dataBytes =
        m_isBase64 ? m_text.size() - std::min<std::uint64_t>(base64Length((3 + count) * m_width), m_text.size())
                   : m_text.size();
    end = first;
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t packed = headerWord(m_head, 3 + i, m_header);
        const std::uint64_t unpacked = i + 1 == count && lastSize != 0 ? lastSize : blockSize;
        if (packed > dataBytes || end + packed > dataBytes) {
            return wrong(
                {PALPATE_TEXT("block %1 reaches beyond the end of the file; its size is %2 bytes"), i, Count(packed)},
                {PALPATE_TEXT("at most %1 bytes"), Count(dataBytes - std::min(end, dataBytes))});
        }
        const std::uint64_t most = (packed + 64) * mostRatio(m_header.compressor);
        if (unpacked > most || unpacked > kMost - m_blocks.m_size) {
            return wrong({PALPATE_TEXT("block %1: declared sizes are %2 bytes compressed and %3 bytes decompressed"), i,
                          Count(packed), Count(unpacked)},
                         {PALPATE_TEXT("at most %1 bytes decompressed"), Count(most)});
        }
        m_blocks.m_blocks.push_back({end, packed, unpacked});
        end += packed;
        m_blocks.m_size += unpacked;
    }
    return {};
}

/// Compressed data: the header contains the number of blocks, the block size, the size of the last block and all
/// compressed sizes.
Status VtpBlockFinder::findPacked(std::uint64_t count)
{
    if (count > m_text.size() / m_width) {
        return wrong(
            {PALPATE_TEXT("number of blocks: declared %1"), Count(count)},
            {PALPATE_TEXT("at most %1, the number of header words that follow"), Count(m_text.size() / m_width)});
    }
    const std::uint64_t blockSize = headerWord(m_head, 1, m_header);
    const std::uint64_t lastSize = headerWord(m_head, 2, m_header);
    if (count > 0 && (blockSize == 0 || lastSize > blockSize)) { // VTK uses this as a divisor
        return wrong(
            {PALPATE_TEXT("block size %1 bytes, size of the last block %2 bytes"), Count(blockSize), Count(lastSize)},
            {PALPATE_TEXT("a block size of at least one byte and a last block that is not larger")});
    }
    const std::uint64_t headBytes = (3 + count) * m_width;
    if (Status status = readHead(headBytes); !status.isOk()) {
        return status;
    }
    std::uint64_t end = 0;
    if (Status status = takeBlocks(count, m_isBase64 ? 0 : headBytes, end); !status.isOk()) {
        return status;
    }
    m_blocks.m_data = m_text;
    if (m_isBase64) {
        m_blocks.m_decoded = std::make_shared<const std::string>(
            fromBase64(m_text.substr(std::min<std::uint64_t>(base64Length(headBytes), m_text.size())), end));
        m_blocks.m_data = *m_blocks.m_decoded;
        if (m_blocks.m_data.size() < end) {
            return wrong({PALPATE_TEXT("size of its data: %1 bytes"), Count(m_blocks.m_data.size())},
                         {PALPATE_TEXT("%1 bytes"), Count(end)});
        }
    }
    return {};
}

Result<VtpBlocks> VtpBlockFinder::run()
{
    if (m_array.format == VtpFormat::Appended) {
        if (m_array.offset >= m_header.appended.size()) {
            return wrong(
                {PALPATE_TEXT("its data begin at offset %1"), Count(m_array.offset)},
                {PALPATE_TEXT("less than %1, the length of the appended data"), Count(m_header.appended.size())});
        }
        m_text = m_header.appended.substr(m_array.offset);
    }
    // The fixed-length part of the header.
    const bool isPacked = m_header.compressor != VtpCompressor::None;
    Status status = readHead((isPacked ? 3 : 1) * m_width);
    if (status.isOk()) {
        const std::uint64_t first = headerWord(m_head, 0, m_header);
        status = isPacked ? findPacked(first) : findPlain(first);
    }
    return status.isOk() ? Result<VtpBlocks>(std::move(m_blocks)) : Result<VtpBlocks>(status);
}

Result<VtpBlocks> VtpBlocks::find(const VtpDataArray& array, const VtpHeader& header, const ScanContext& context)
{
    return VtpBlockFinder(array, header, context).run();
}

std::optional<std::vector<unsigned char>> VtpBlocks::unpack() const
{
    std::vector<unsigned char> out(m_size);
    vtkSmartPointer<vtkDataCompressor> compressor;
    switch (m_compressor) {
    case VtpCompressor::ZLib:
        compressor = vtkSmartPointer<vtkZLibDataCompressor>::New();
        break;
    case VtpCompressor::Lz4:
        compressor = vtkSmartPointer<vtkLZ4DataCompressor>::New();
        break;
    case VtpCompressor::Lzma:
        compressor = vtkSmartPointer<vtkLZMADataCompressor>::New();
        break;
    case VtpCompressor::None:
        if (m_size > 0) {
            std::memcpy(out.data(), m_data.data() + m_blocks.front().begin, m_size);
        }
        return out;
    }
    const VtkMessages messages;
    std::uint64_t done = 0;
    for (const Block& block : m_blocks) {
        const auto* from = reinterpret_cast<const unsigned char*>(m_data.data()) + block.begin;
        if (compressor->Uncompress(from, block.packed, out.data() + done, block.unpacked) != block.unpacked) {
            return std::nullopt;
        }
        done += block.unpacked;
    }
    return out;
}

std::size_t vtpTypeSize(std::string_view type)
{
    static constexpr std::array<std::pair<std::string_view, std::size_t>, 10> kSizes{{{"Int8", 1},
                                                                                      {"UInt8", 1},
                                                                                      {"Int16", 2},
                                                                                      {"UInt16", 2},
                                                                                      {"Int32", 4},
                                                                                      {"UInt32", 4},
                                                                                      {"Int64", 8},
                                                                                      {"UInt64", 8},
                                                                                      {"Float32", 4},
                                                                                      {"Float64", 8}}};
    const auto found = std::find_if(kSizes.begin(), kSizes.end(), [&](const auto& s) { return s.first == type; });
    return found == kSizes.end() ? 0 : found->second;
}

bool isVtpIntegerType(std::string_view type)
{
    return vtpTypeSize(type) > 0 && !type.starts_with("Float");
}

std::vector<std::int64_t> vtpIntegers(std::span<const unsigned char> bytes, std::string_view type, bool isBigEndian)
{
    const std::size_t size = vtpTypeSize(type);
    const bool isSigned = !type.starts_with('U');
    std::vector<std::int64_t> out;
    out.reserve(bytes.size() / size);
    for (std::size_t at = 0; at + size <= bytes.size(); at += size) {
        std::uint64_t word = 0;
        for (std::size_t k = 0; k < size; ++k) {
            word |= std::uint64_t{bytes[at + (isBigEndian ? size - 1 - k : k)]} << (8 * k);
        }
        const std::size_t unused = 64 - 8 * size;
        out.push_back(isSigned ? static_cast<std::int64_t>(word << unused) >> unused : static_cast<std::int64_t>(word));
    }
    return out;
}

} // namespace palpate::meshio::internal
