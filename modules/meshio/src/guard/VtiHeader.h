// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <cstdint>
#include <filesystem>

namespace palpate::meshio::internal {

/// Checks the fields that the VTI reader trusts: the reader loops over the declared components of an array before
/// reading numbers, and accepts a short read of appended data (`vtkXMLDataParser::ReadUncompressedData`), which leaves
/// the missing numbers uninitialised. The check is that the file ends with the last tag.
/// @param most  limit on the numbers per voxel declared by all arrays together; below 2^32
/// @return the numbers per voxel
[[nodiscard]] core::Result<std::uint64_t> checkVti(const std::filesystem::path& source, std::uint64_t most);

} // namespace palpate::meshio::internal
