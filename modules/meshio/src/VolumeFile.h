// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/FileFrame.h>
#include <palpate/core/Status.h>

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace palpate::meshio::internal {

/// A volume of one number a voxel, in LPS.
struct VoxelGrid
{
    std::array<std::uint32_t, 3> size{};                   ///< voxels along each axis, each at least 1; x fastest
    Eigen::Affine3d toVoxel = Eigen::Affine3d::Identity(); ///< from LPS [mm] to numbers of voxels; finite
    std::vector<float> values; ///< one a voxel; what the file has as infinite or not a number stays that
};

/// The most voxels of a volume.
inline constexpr std::uint64_t kMostVoxels = std::uint64_t{1} << 30;

/// @return what the file of a volume takes on the disk, with the file of its numbers where that is another one (`.mhd`,
/// `.nhdr`) [bytes]
[[nodiscard]] std::uint64_t volumeBytes(const std::filesystem::path& path);

/// Reads a volume (`.vti`, `.mha`, `.mhd`, `.nrrd`, `.nhdr`, `.nii`, `.nii.gz`; mm; NIfTI and what says RAS are turned
/// to LPS) in a child process where there is an import server, else here.
/// @param frame  the axes of a file that says none (`.vti`, NRRD without `space`)
/// @param progress  told the share done, 0 … 1; return false to cancel. Called on this thread. May be empty
/// @return one line that names the file, what was found and what was expected, if it can't be read whole
/// @par Thread Any.
[[nodiscard]] core::Result<VoxelGrid> readVolume(const std::filesystem::path& path, core::FileFrame frame,
                                                 const std::function<bool(double)>& progress);

/// The same in this process, whatever VTK's readers do to it.
[[nodiscard]] core::Result<VoxelGrid> readVolumeHere(const std::filesystem::path& path, core::FileFrame frame,
                                                     const std::function<bool(double)>& progress);

/// Writes the outcome of a read into an empty memory file. @return false when that does not take it
[[nodiscard]] bool writeVolume(int descriptor, core::Result<VoxelGrid> outcome);
/// Takes an outcome out of a memory file. Nothing is believed: size, axes and counts are checked.
/// @param path  the file that was read; names it in messages
[[nodiscard]] core::Result<VoxelGrid> takeVolume(int descriptor, const std::filesystem::path& path);

} // namespace palpate::meshio::internal
