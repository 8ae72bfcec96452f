// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "guard/FileImage.h"

#include <cstdint>
#include <string_view>

namespace palpate::meshio::internal {

/// @return true for the content of a gzip file
[[nodiscard]] bool isGzip(std::string_view bytes);

/// @param size  of the packed file [bytes]
/// @param last  its last four bytes
/// @return the size of the content that the file states [bytes], at most what `unpackGzip` accepts
[[nodiscard]] std::uint64_t statedGzipSize(std::uint64_t size, std::string_view last);

/// Unpacks a mesh. The content must have the size that the last four bytes state, at most 100 times that of the file:
/// a mesh never packs better, and the limits of the reading process follow from this size.
/// @param file  name for messages
[[nodiscard]] core::Result<FileImage> unpackGzip(std::string_view bytes, std::string_view file);

} // namespace palpate::meshio::internal
