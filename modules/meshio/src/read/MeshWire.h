// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/meshio/MeshFile.h"

namespace palpate::meshio::internal {

/// Writes the outcome of a read to an empty memory file, and frees each structure once written.
/// @return false when writing fails
[[nodiscard]] bool writeOutcome(int descriptor, core::Result<MeshFile> outcome);

/// Reads an outcome from a memory file and releases the file's pages on the way, so that a large mesh is never in
/// memory twice. The content is untrusted: checks every size, index, coordinate and text.
/// @param path     the mesh file, for messages
[[nodiscard]] core::Result<MeshFile> readOutcome(int descriptor, const std::filesystem::path& path);

} // namespace palpate::meshio::internal
