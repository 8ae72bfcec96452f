// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/FileFrame.h>
#include <palpate/core/Status.h>
#include <palpate/geometry/VoxelVolume.h>

#include <cstdint>
#include <filesystem>
#include <functional>

namespace palpate::meshio::internal {

using VoxelGrid = geometry::VoxelVolume;

/// Largest number of voxels in a volume.
inline constexpr std::uint64_t kMostVoxels = std::uint64_t{1} << 30;

/// @return the size of a volume on disk, including a separate data file (`.mhd`, `.nhdr`) [bytes]
[[nodiscard]] std::uint64_t volumeBytes(const std::filesystem::path& path);

/// Reads a volume (`.vti`, `.mha`, `.mhd`, `.nrrd`, `.nhdr`, `.nii`, `.nii.gz`; mm; NIfTI and RAS volumes are converted
/// to LPS) in a child process with an import server, otherwise in this process. The numbers are those that the stored
/// ones stand for (NIfTI's `scl_slope` and `scl_inter`).
/// @param frame  axes for a file without a stated space (`.vti`, NRRD without `space`, NIfTI without sform and qform)
/// @param progress  progress callback (0 to 1); return false to cancel. Called on this thread. May be empty
/// @return on failure one line with the file, the found and the expected value
/// @par Thread Any.
[[nodiscard]] core::Result<VoxelGrid> readVolume(const std::filesystem::path& path, core::FileFrame frame,
                                                 const std::function<bool(double)>& progress);

/// Same in this process: a crash or an endless loop of VTK's reader of `.vti` affects the caller. Throws
/// std::bad_alloc.
[[nodiscard]] core::Result<VoxelGrid> readVolumeHere(const std::filesystem::path& path, core::FileFrame frame,
                                                     const std::function<bool(double)>& progress);

/// Writes the outcome of a read to an empty memory file. @return false when writing fails
[[nodiscard]] bool writeVolume(int descriptor, core::Result<VoxelGrid> outcome);
/// Reads an outcome from a memory file. The content is untrusted: checks size, axes and counts.
/// @param path  the volume file, for messages
[[nodiscard]] core::Result<VoxelGrid> takeVolume(int descriptor, const std::filesystem::path& path);

} // namespace palpate::meshio::internal
