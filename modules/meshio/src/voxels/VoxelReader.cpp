// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/VoxelReader.h"

#include "voxels/Unpack.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace palpate::meshio::internal {

namespace {

using core::Message;
using core::Status;
using core::StatusCode;

constexpr std::size_t kVoxelBlock = std::size_t{1} << 16; ///< voxels
constexpr std::size_t kFilePiece = std::size_t{1} << 20;  ///< of a separate file [bytes]
constexpr std::uint64_t kMostInflated = 1100;             ///< bytes that zlib can make of one

/// A separate file of voxels.
struct DataFile
{
    std::filesystem::path path;
    std::uint64_t bytes = 0; ///< its size
    std::uint64_t begin = 0; ///< of the voxels [bytes]
};

/// Stored bytes of the voxels: in the file of the header, or in separate files one after the other.
class StoredBytes
{
  public:
    StoredBytes(std::string_view here, std::vector<DataFile> files)
        : m_here(here)
        , m_files(std::move(files))
    {
    }
    std::string_view next()
    {
        if (m_files.empty()) {
            return std::exchange(m_here, {});
        }
        m_piece.resize(kFilePiece);
        while (m_at < m_files.size()) {
            if (!m_in.is_open()) {
                m_in.open(m_files[m_at].path, std::ios::binary);
                m_in.seekg(static_cast<std::streamoff>(m_files[m_at].begin));
            }
            m_in.read(m_piece.data(), static_cast<std::streamsize>(m_piece.size()));
            if (const auto got = static_cast<std::size_t>(m_in.gcount()); got > 0) {
                return std::string_view(m_piece).substr(0, got);
            }
            m_in = std::ifstream();
            ++m_at;
        }
        return {};
    }

  private:
    std::string_view m_here;
    std::vector<DataFile> m_files;
    std::size_t m_at = 0;
    std::ifstream m_in;
    std::string m_piece;
};

template<class T>
void decodeAs(const char* raw, bool isSwapped, std::span<double> out)
{
    for (double& number : out) {
        std::array<char, sizeof(T)> bytes{};
        std::memcpy(bytes.data(), raw, sizeof(T));
        raw += sizeof(T);
        if (isSwapped) {
            std::reverse(bytes.begin(), bytes.end());
        }
        T value;
        std::memcpy(&value, bytes.data(), sizeof(T));
        number = static_cast<double>(value);
    }
}

void decode(const VolumeLayout& layout, const char* raw, std::span<double> out)
{
    const bool isSwapped = layout.isBigEndian; // this program runs on little-endian machines only
    switch (layout.type) {
    case VoxelType::Int8:
        decodeAs<std::int8_t>(raw, isSwapped, out);
        break;
    case VoxelType::UInt8:
        decodeAs<std::uint8_t>(raw, isSwapped, out);
        break;
    case VoxelType::Int16:
        decodeAs<std::int16_t>(raw, isSwapped, out);
        break;
    case VoxelType::UInt16:
        decodeAs<std::uint16_t>(raw, isSwapped, out);
        break;
    case VoxelType::Int32:
        decodeAs<std::int32_t>(raw, isSwapped, out);
        break;
    case VoxelType::UInt32:
        decodeAs<std::uint32_t>(raw, isSwapped, out);
        break;
    case VoxelType::Int64:
        decodeAs<std::int64_t>(raw, isSwapped, out);
        break;
    case VoxelType::UInt64:
        decodeAs<std::uint64_t>(raw, isSwapped, out);
        break;
    case VoxelType::Float32:
        decodeAs<float>(raw, isSwapped, out);
        break;
    case VoxelType::Float64:
        decodeAs<double>(raw, isSwapped, out);
        break;
    }
    if (layout.slope != 1.0 || layout.intercept != 0.0) {
        for (double& number : out) {
            number = layout.slope * number + layout.intercept;
        }
    }
}

/// Checks the declared bytes against the stored ones. @param stored  bytes of the voxels in the files
Status checkStored(const VolumeLayout& layout, std::uint64_t stored, const std::string& file)
{
    const std::uint64_t declared = layout.voxels() * bytesOf(layout.type);
    if (declared > (layout.isPacked ? stored * kMostInflated : stored)) {
        return fault(StatusCode::OutOfRange, file, Message(),
                     Message(PALPATE_TEXT("%1 voxels declared"), core::Count(layout.voxels())),
                     Message(PALPATE_TEXT("as many as its %1 bytes can hold"), core::Count(stored)));
    }
    return {};
}

/// Finds the files that the header names. @param path  of the header
core::Result<std::vector<DataFile>> dataFilesOf(const VolumeLayout& layout, const std::filesystem::path& path)
{
    const std::string file = path.filename().string();
    std::vector<DataFile> files;
    for (const std::string& name : layout.dataFiles) {
        const Message place(PALPATE_TEXT("header: file of the voxels"));
        const Message expected(PALPATE_TEXT("a file in this folder or below it"));
        const std::filesystem::path below = std::filesystem::path(name).lexically_normal();
        if (below.empty() || below.is_absolute() || *below.begin() == "..") {
            return fault(StatusCode::Unsupported, file, place, Message(PALPATE_TEXT("%1"), inQuotes(name)), expected);
        }
        std::error_code error;
        const std::filesystem::path whole = path.parent_path() / below;
        const std::uintmax_t size = std::filesystem::file_size(whole, error);
        if (error || !std::filesystem::is_regular_file(whole, error)) {
            return fault(StatusCode::NotFound, file, place, Message(PALPATE_TEXT("no file %1"), inQuotes(name)),
                         expected);
        }
        files.push_back({whole, size, 0});
    }
    return files;
}

/// @return the first byte of the voxels in a file of `stored` bytes, of which the voxels have `declared`
std::uint64_t beginOf(const VolumeLayout& layout, std::uint64_t stored, std::uint64_t declared)
{
    const std::uint64_t fromEnd = layout.isAtEnd ? stored - std::min(stored, declared) : 0;
    return std::min(stored, std::max(layout.offset, fromEnd));
}

} // namespace

Status readVoxels(const VolumeLayout& layout, std::string_view bytes, const std::filesystem::path& path,
                  const std::function<bool(double)>& progress, const std::function<bool(std::span<const double>)>& take)
{
    const std::string file = path.filename().string();
    core::Result<std::vector<DataFile>> found = dataFilesOf(layout, path);
    if (!found.isOk()) {
        return found.status();
    }
    std::vector<DataFile> files = std::move(found).value();
    const std::uint64_t declared = layout.voxels() * bytesOf(layout.type);
    const std::uint64_t begin = layout.isWholePacked ? 0 : beginOf(layout, bytes.size(), declared);
    std::uint64_t stored = files.empty() ? bytes.size() - begin : 0;
    for (DataFile& each : files) {
        const std::uint64_t share = declared / files.size();
        each.begin = beginOf(layout, each.bytes, share);
        stored += each.bytes - each.begin;
        if (files.size() > 1 && each.bytes - each.begin != share) { // otherwise all that follows would be shifted
            return fault(
                StatusCode::BadFormat, file, Message(PALPATE_TEXT("header: file of the voxels")),
                Message(PALPATE_TEXT("%1 with %2 bytes of voxels"), inQuotes(each.path.filename().string()),
                        core::Count(each.bytes - each.begin)),
                Message(PALPATE_TEXT("%1 in each of %2 files"), core::Count(share), core::Count(files.size())));
        }
    }
    if (Status status = checkStored(layout, stored, file); !status.isOk()) {
        return status;
    }
    StoredBytes source(bytes.substr(begin), std::move(files));
    ByteStream stream([&source] { return source.next(); }, layout.isPacked);
    const std::size_t each = bytesOf(layout.type);
    std::string raw(kVoxelBlock * each, '\0');
    for (std::uint64_t skip = layout.isWholePacked ? layout.offset : 0; skip > 0;) {
        const std::size_t got = stream.read({raw.data(), std::min<std::size_t>(raw.size(), skip)});
        skip -= got;
        if (got == 0) {
            break; // the first block reports it
        }
    }
    std::vector<double> numbers(kVoxelBlock);
    const std::uint64_t voxels = layout.voxels();
    for (std::uint64_t done = 0; done < voxels;) {
        const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(kVoxelBlock, voxels - done));
        const std::size_t got = stream.read({raw.data(), count * each});
        if (got != count * each) {
            return fault(StatusCode::BadFormat, file, Message(),
                         Message(PALPATE_TEXT("%1 of %2 bytes of voxels"), core::Count(done * each + got),
                                 core::Count(voxels * each)),
                         stream.isDamaged() ? Message(PALPATE_TEXT("compressed data that are complete and undamaged"))
                                            : Message(PALPATE_TEXT("all")));
        }
        const std::span<double> block(numbers.data(), count);
        decode(layout, raw.data(), block);
        if (!take(block)) {
            return {};
        }
        done += count;
        if (progress && !progress(static_cast<double>(done) / static_cast<double>(voxels))) {
            return {StatusCode::Cancelled, PALPATE_TEXT("%1: reading was cancelled"), file};
        }
    }
    const std::size_t more = stream.read(raw);
    // Zeros behind the voxels fill the last block of a file.
    constexpr std::size_t kBlock = 512;
    const std::string_view end(raw.data(), std::min(more, kBlock));
    const bool isFilled = more < kBlock && end.find_first_not_of('\0') == std::string_view::npos;
    if ((!isFilled && end != "\n" && end != "\r\n") || stream.isDamaged()) {
        return fault(StatusCode::BadFormat, file, Message(),
                     stream.isDamaged()
                         ? Message(PALPATE_TEXT("damaged compressed data"))
                         : Message(PALPATE_TEXT("more bytes than its %1 voxels have"), core::Count(voxels)),
                     Message(PALPATE_TEXT("%1 bytes of voxels"), core::Count(voxels * each)));
    }
    return {};
}

} // namespace palpate::meshio::internal
