// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/TriangleMesh.h>

#include <functional>

namespace palpate::test {

using core::Vec3;
using geometry::TriangleMesh;

/// A grid of voxels around the origin and which of them belong to a structure, by the voxel's centre. [mm]
struct Mask
{
    Vec3 voxel_mm = Vec3::Ones();
    Vec3 half_mm = Vec3::Ones(); ///< the grid reaches so far from the origin along each axis, at least
    std::function<bool(const Vec3& centre_mm)> contains;
};

/// Marching cubes on a binary mask, as scripts write it without smoothing: corners halfway between voxel centres.
/// Closed where the grid's outermost voxels are empty, normals outwards.
TriangleMesh maskSurface(const Mask& mask);
/// The faces of the voxels themselves, two triangles each, normals outwards.
TriangleMesh voxelFaces(const Mask& mask);

/// A ball, whose centre lies a little off the grid's so that no voxel is on its surface by rounding alone.
Mask ballMask(double radius_mm, const Vec3& voxel_mm);
Vec3 ballCentre_mm(const Vec3& voxel_mm);

} // namespace palpate::test
