// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxels/VolumeLayout.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::meshio::internal {

/// Image of VTK: the place of its voxels, and one number per voxel. The axes of the file are not stated.
struct VtiVolume
{
    VolumeLayout layout; ///< size, steps and origin
    std::vector<float> values;
};

[[nodiscard]] bool looksLikeVti(std::string_view bytes);

/// Reads a `.vti` file with one number per point, or per cell if it has none per point. The pieces must cover the whole
/// extent, and an array must have exactly as many numbers as its piece has voxels.
/// @param bytes     the whole file
/// @param file      name for messages
/// @param progress  callback (0 to 1); false cancels. May be empty
[[nodiscard]] core::Result<VtiVolume> vtiVolume(std::string_view bytes, const std::string& file,
                                                const std::function<bool(double)>& progress);

} // namespace palpate::meshio::internal
