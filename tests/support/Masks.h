// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/TriangleMesh.h>

#include <functional>

namespace palpate::test {

using core::Vec3;
using geometry::TriangleMesh;

/// A voxel grid around the origin, and which voxels belong to a structure, by voxel centre [mm].
struct Mask
{
    Vec3 voxel_mm = Vec3::Ones();
    Vec3 half_mm = Vec3::Ones(); ///< minimum extent of the grid from the origin along each axis
    std::function<bool(const Vec3& centre_mm)> contains;
};

/// Returns marching cubes on a binary mask, as scripts produce without smoothing: corners halfway between voxel
/// centres. Closed where the grid's outermost voxels are empty, normals outwards.
TriangleMesh maskSurface(const Mask& mask);
/// Returns the faces of the voxels, two triangles each, normals outwards.
TriangleMesh voxelFaces(const Mask& mask);

/// Returns a ball whose centre is slightly off the grid, so that rounding never decides whether a voxel is inside.
Mask ballMask(double radius_mm, const Vec3& voxel_mm);
Vec3 ballCentre_mm(const Vec3& voxel_mm);

} // namespace palpate::test
