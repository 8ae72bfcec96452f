// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/SurfaceSection.h"

#include <palpate/core/Export.h>
#include <palpate/core/Types.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace palpate::geometry {

/// A volume with one number per voxel, in the world frame LPS: an image of CT, MR or ultrasound, or a map of tissue.
struct VoxelVolume
{
    std::array<std::uint32_t, 3> size{};                   ///< voxels along each axis, each at least 1; x fastest
    Eigen::Affine3d toVoxel = Eigen::Affine3d::Identity(); ///< from LPS [mm] to voxel indices; finite and invertible
    std::vector<float> values; ///< one per voxel; infinite values and NaN are kept from the file

    /// Interpolates trilinearly. @param voxel  indices, each from 0 to size - 1
    [[nodiscard]] PALPATE_EXPORT double at(const Vec3& voxel) const;
    /// The same at a position in LPS [mm]. Within half a voxel beyond the centres of the outer voxels, their value.
    /// @return empty outside
    [[nodiscard]] PALPATE_EXPORT std::optional<double> numberAt(const Vec3& p_W) const;
};

/// Range of numbers that is shown from black to white.
struct GreyWindow
{
    double level = 0.5; ///< number shown in medium grey
    double width = 1.0; ///< from black to white; above 0
    friend bool operator==(const GreyWindow&, const GreyWindow&) = default;
};

/// Window that shows a volume well: from the 1st to the 99th percentile of its finite numbers. The lowest
/// number, with which the surroundings of the patient are often filled, is left out of the percentiles.
/// @par Cost O(voxels), from at most a million of them
[[nodiscard]] PALPATE_EXPORT GreyWindow usualWindow(const VoxelVolume& volume);

/// Corners of the area in which a plane cuts a volume, in order; empty if the plane misses the volume. The volume ends
/// half a voxel beyond the centres of the outer voxels.
[[nodiscard]] PALPATE_EXPORT std::vector<Eigen::Vector2d> cutOf(const VoxelVolume& volume, const SectionPlane& plane);

/// Grey picture of a plane in a volume.
struct VolumeSlice
{
    std::vector<Eigen::Vector2d> outline; ///< cutOf; empty: nothing to show
    Eigen::AlignedBox2d box{};            ///< of the outline, covered by the picture [mm]
    int columns = 0, rows = 0;
    std::vector<std::uint8_t> greys; ///< rows x columns, by increasing second coordinate; unknown numbers are black
};

/// Slices a volume. The picture has a pixel for each voxel that the plane passes, at most `most` along a side.
/// @par Cost 10 ns per pixel, on several threads
[[nodiscard]] PALPATE_EXPORT VolumeSlice sliceOf(const VoxelVolume& volume, const SectionPlane& plane,
                                                 const GreyWindow& window, int most = 768);

} // namespace palpate::geometry
