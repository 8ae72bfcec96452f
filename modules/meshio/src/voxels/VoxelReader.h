// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxels/VolumeLayout.h"

#include <filesystem>
#include <functional>
#include <span>
#include <string_view>

namespace palpate::meshio::internal {

/// Reads the voxels of a volume in file order, in blocks. The declared bytes must be present before the first block,
/// and the file must end after the last.
/// @param bytes     of the file with the header
/// @param path      of this file; names of separate files are relative to its folder
/// @param progress  callback (0 to 1); false cancels. May be empty
/// @param take      receives the values of consecutive voxels; false ends the reading early without an error
[[nodiscard]] core::Status readVoxels(const VolumeLayout& layout, std::string_view bytes,
                                      const std::filesystem::path& path, const std::function<bool(double)>& progress,
                                      const std::function<bool(std::span<const double>)>& take);

} // namespace palpate::meshio::internal
