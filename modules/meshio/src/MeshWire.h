// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/meshio/MeshFile.h"

namespace palpate::meshio::internal {

/// Writes the outcome of a read into an empty memory file, and frees each structure as soon as it is written.
/// @return false when the memory file does not take it
[[nodiscard]] bool writeOutcome(int descriptor, core::Result<MeshFile> outcome);

/// Takes an outcome out of a memory file, whose pages are given back on the way, so that a large mesh is never in
/// memory twice. Nothing is believed: every size, index, coordinate and text is checked.
/// @param path     the file that was read; names it in messages
[[nodiscard]] core::Result<MeshFile> readOutcome(int descriptor, const std::filesystem::path& path);

} // namespace palpate::meshio::internal
