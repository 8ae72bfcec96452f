// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/FileFrame.h>
#include <palpate/core/Status.h>
#include <palpate/core/Types.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace palpate::meshio::internal {

/// A displacement at each voxel of a grid, in the world frame LPS, as a registration writes it.
struct FieldGrid
{
    std::array<std::uint32_t, 3> size{};                   ///< voxels along each axis, each at least 1; x fastest
    Eigen::Affine3d toVoxel = Eigen::Affine3d::Identity(); ///< from LPS [mm] to voxel indices; finite and invertible
    std::vector<std::array<float, 3>> values;              ///< one per voxel [mm], finite

    /// Returns true for a position at most half a voxel beyond the centres of the outer voxels.
    [[nodiscard]] bool covers(const core::Vec3& p_W) const;
    /// Interpolates trilinearly; beyond the outer voxels the nearest value. [mm]
    [[nodiscard]] core::Vec3 at(const core::Vec3& p_W) const;
};

/// Reads a displacement field: a volume with three numbers per voxel that are marked as a vector, from NRRD (a kind
/// that ends in `vector`, or none), MetaImage (three channels) or NIfTI (intent 1006 or 1007). In a child process with
/// an import server, otherwise in this process.
/// @param frame  axes for a file without a stated space
/// @return on failure one line with the file, the found and the expected value; a number that is not finite is an error
/// @par Thread Any.
[[nodiscard]] core::Result<FieldGrid> readField(const std::filesystem::path& path, core::FileFrame frame);

/// Same in this process. Throws std::bad_alloc.
/// @param progress  progress callback (0 to 1); return false to cancel. May be empty
[[nodiscard]] core::Result<FieldGrid> readFieldHere(const std::filesystem::path& path, core::FileFrame frame,
                                                    const std::function<bool(double)>& progress);

/// As writeVolume and takeVolume.
[[nodiscard]] bool writeField(int descriptor, core::Result<FieldGrid> outcome);
[[nodiscard]] core::Result<FieldGrid> takeField(int descriptor, const std::filesystem::path& path);

} // namespace palpate::meshio::internal
