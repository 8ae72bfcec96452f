// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::meshio::internal {

/// A mesh file that a multi-block file names.
struct Block
{
    std::filesystem::path file; ///< absolute
    std::string name;           ///< empty: by the mesh file
};

/// @return true for a file of VTK that only names other files: a multi-block data set (.vtm) or a collection of
/// ParaView (.pvd).
[[nodiscard]] bool isBlockFile(const std::filesystem::path& path);

/// Reads the names of the mesh files. A file in another folder tree, a collection of several time steps, more than 4
/// MiB and broken XML are errors.
[[nodiscard]] core::Result<std::vector<Block>> readBlocks(const std::filesystem::path& path);

} // namespace palpate::meshio::internal
