// SPDX-License-Identifier: BSD-3-Clause
#include "VtpBlocks.h"

#include "Fault.h"
#include "TextScan.h"
#include "VtkMessages.h"

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

/// The most that a compressor can pack into one byte; a claim beyond it is not true.
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

/// Decodes up to `most` bytes from the start of a base64 stream; fewer when it ends before.
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

/// @return characters that base64 takes for `bytes` bytes
std::uint64_t base64Length(std::uint64_t bytes)
{
    return (bytes + 2) / 3 * 4;
}

/// Word `i` of a block header. @pre it lies inside `data`
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

Result<VtpBlocks> VtpBlocks::find(const VtpArray& array, const VtpHeader& header, const ScanContext& context)
{
    const bool isAppended = array.format == VtpFormat::Appended;
    const bool isBase64 = !isAppended || header.isAppendedBase64;
    const auto wrong = [&](std::string_view found, std::string_view expected) {
        return fault(StatusCode::OutOfRange, context.file, atLine(array.line),
                     "array " + inQuotes(array.name) + ": " + std::string(found), expected);
    };
    std::string_view text = trimmed({array.text.constData(), static_cast<std::size_t>(array.text.size())});
    if (isAppended) {
        if (array.offset >= header.appended.size()) {
            return wrong("its data begin at offset " + grouped(array.offset),
                         "less than " + grouped(header.appended.size()) + ", the length of the appended data");
        }
        text = header.appended.substr(array.offset);
    }
    const std::uint64_t width = header.hasWideHeaders ? 8 : 4;
    const bool isPacked = header.compressor != VtpCompressor::None;
    VtpBlocks blocks;
    blocks.m_compressor = header.compressor;

    // The part of the header whose length is known.
    std::uint64_t headerBytes = (isPacked ? 3 : 1) * width;
    std::string decodedHeader = isBase64 ? fromBase64(text, headerBytes) : std::string();
    std::string_view head = isBase64 ? decodedHeader : text;
    if (head.size() < headerBytes) {
        return wrong("the file ends in the header of its data", counted(headerBytes, "byte"));
    }
    const std::uint64_t first = headerWord(head, 0, header);
    if (!isPacked) {
        std::string_view data = text;
        if (isBase64) {
            if (first > text.size()) {
                return wrong(grouped(first) + " bytes declared",
                             "at most " + grouped(text.size()) + ", the characters that are left");
            }
            blocks.m_decoded = std::make_shared<const std::string>(fromBase64(text, headerBytes + first));
            data = *blocks.m_decoded;
        }
        if (first > data.size() - headerBytes) {
            return wrong(grouped(first) + " bytes declared",
                         "at most " + grouped(data.size() - headerBytes) + ", the bytes that are left");
        }
        blocks.m_data = data;
        blocks.m_blocks.push_back({headerBytes, first, first});
        blocks.m_size = first;
        return blocks;
    }

    if (first > text.size() / width) {
        return wrong(grouped(first) + " blocks declared",
                     "at most " + grouped(text.size() / width) + ", the words that are left");
    }
    const std::uint64_t blockSize = headerWord(head, 1, header);
    const std::uint64_t lastSize = headerWord(head, 2, header);
    if (first > 0 && (blockSize == 0 || lastSize > blockSize)) { // VTK divides by it
        return wrong("blocks of " + counted(blockSize, "byte") + ", the last of " + grouped(lastSize),
                     "blocks of at least one byte, none larger than the others");
    }
    headerBytes += first * width;
    if (isBase64) {
        decodedHeader = fromBase64(text, headerBytes);
        head = decodedHeader;
    }
    if (head.size() < headerBytes) {
        return wrong("the file ends in the header of its data", counted(headerBytes, "byte"));
    }
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max() / 4;
    std::uint64_t packedEnd = isBase64 ? 0 : headerBytes;
    const std::uint64_t dataBytes =
        isBase64 ? text.size() - std::min(base64Length(headerBytes), text.size()) : text.size();
    for (std::uint64_t i = 0; i < first; ++i) {
        const std::uint64_t packed = headerWord(head, 3 + i, header);
        const std::uint64_t unpacked = i + 1 == first && lastSize != 0 ? lastSize : blockSize;
        if (packed > dataBytes || packedEnd + packed > dataBytes) {
            return wrong("block " + std::to_string(i) + " of " + grouped(packed) + " bytes reaches beyond the file",
                         "at most " + grouped(dataBytes - std::min(packedEnd, dataBytes)));
        }
        const std::uint64_t most = (packed + 64) * mostRatio(header.compressor);
        if (unpacked > most || unpacked > kMost - blocks.m_size) {
            return wrong("block " + std::to_string(i) + " of " + grouped(packed) + " bytes is said to unpack to " +
                             grouped(unpacked),
                         "at most " + grouped(most));
        }
        blocks.m_blocks.push_back({packedEnd, packed, unpacked});
        packedEnd += packed;
        blocks.m_size += unpacked;
    }
    blocks.m_data = text;
    if (isBase64) {
        blocks.m_decoded = std::make_shared<const std::string>(
            fromBase64(text.substr(std::min<std::uint64_t>(base64Length(headerBytes), text.size())), packedEnd));
        blocks.m_data = *blocks.m_decoded;
        if (blocks.m_data.size() < packedEnd) {
            return wrong(grouped(blocks.m_data.size()) + " bytes of data", grouped(packedEnd));
        }
    }
    return blocks;
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
