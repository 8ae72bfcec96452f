// SPDX-License-Identifier: BSD-3-Clause
#include "formats/Gzip.h"

#include "text/Fault.h"
#include "voxels/Unpack.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

namespace palpate::meshio::internal {

using core::Result;
using core::StatusCode;

namespace {

constexpr std::size_t kLeastGzip = 18;       ///< header and trailer [bytes]
constexpr std::size_t kStated = 4;           ///< the size of the content, little-endian, at the end [bytes]
constexpr std::uint64_t kMostOfOne = 100;    ///< bytes from one byte of the file
constexpr std::uint64_t kAlways = 1U << 16U; ///< accepted for a file of any size [bytes]

std::uint64_t sizeIn(std::string_view last)
{
    std::uint64_t size = 0;
    for (std::size_t i = 0; i < kStated; ++i) {
        size |= std::uint64_t{static_cast<unsigned char>(last[i])} << (8 * i);
    }
    return size;
}

} // namespace

bool isGzip(std::string_view bytes)
{
    return bytes.starts_with("\x1f\x8b\x08");
}

std::uint64_t statedGzipSize(std::uint64_t size, std::string_view last)
{
    return last.size() < kStated ? 0 : std::min(sizeIn(last), size * kMostOfOne + kAlways);
}

Result<FileImage> unpackGzip(std::string_view bytes, std::string_view file)
{
    if (bytes.size() < kLeastGzip) {
        return fault(StatusCode::BadFormat, file, onByte(bytes.size()), {PALPATE_TEXT("the gzip file is cut off")},
                     {PALPATE_TEXT("the whole file")});
    }
    const std::string_view last = bytes.substr(bytes.size() - kStated);
    const std::uint64_t size = sizeIn(last);
    if (size > statedGzipSize(bytes.size(), last)) {
        return fault(StatusCode::OutOfRange, file, onByte(bytes.size() - kStated),
                     {PALPATE_TEXT("%1 bytes when unpacked"), Count(size)},
                     {PALPATE_TEXT("at most %1 times the size of the file: unpack it first (gunzip)"), kMostOfOne});
    }
    Result<FileImage> image = FileImage::allocate(size, file);
    if (!image.isOk()) {
        return image;
    }
    std::string_view rest = bytes;
    ByteStream stream([&rest] { return std::exchange(rest, std::string_view()); }, true);
    char more = 0;
    const std::size_t got = stream.read(image.value().writable());
    const bool isMore = stream.read(std::span(&more, 1)) != 0;
    if (got != size || isMore || stream.isDamaged()) {
        return fault(
            StatusCode::BadFormat, file, {},
            isMore ? core::Message(PALPATE_TEXT("more than %1 bytes when unpacked"), Count(size))
                   : core::Message(PALPATE_TEXT("the gzip data are cut off or damaged")),
            {PALPATE_TEXT("%1 bytes, as its end states: unpack it with gunzip, which names the damage"), Count(size)});
    }
    return image;
}

} // namespace palpate::meshio::internal
