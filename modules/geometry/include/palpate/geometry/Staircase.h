// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/TriangleMesh.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <string>

namespace palpate::geometry {

/// The steps of a surface that was made from a binary mask (a label map) without smoothing. A god-object rests on each
/// step, and the force differs from that of the true surface by a multiple.
struct Staircase
{
    Vec3 voxel_mm = Vec3::Ones(); ///< size of a voxel along each of `axes` [mm], all > 0
    /// Columns: unit directions of a voxel's edges, the first nearest to x and so on.
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    double areaShare = 1.0; ///< of the area, in the kDirections most frequent normals [0 … 1]

    static constexpr int kDirections = 60; ///< normals within 1° are one direction

    /// "staircase of about 1 × 1 × 3 mm voxels (97 % of the area in 60 directions)"
    [[nodiscard]] std::string sentence() const;
};

/// Recognises a surface that was extracted from a binary mask, by its geometry alone: marching cubes puts every vertex
/// halfway along an edge of the voxel grid, so that
/// 1. few directions of normals hold the area. Measured: masks 100 %, masks after smoothing 2 to 5 %, segmented organs
///    3 to 10 % in 60 directions; at least 50 % is asked for, and more than 60 triangles;
/// 2. three of them are perpendicular, and along each the corners of a triangle lie 0, one half or one voxel apart;
///    voxel faces (corners 0 or one voxel apart) count as well. Again for at least 50 % of the area;
/// 3. there are steps: at least 15 % of the area lies elsewhere than in the outermost planes across the axes, or 33 %
///    where no edge is bevelled as marching cubes does it. A box lies in these planes wholly, however finely it is
///    divided.
///
/// Facets larger than a voxel fail the second condition: CAD parts whose edges happen to fit a grid are no staircase.
/// @param mesh  welded or not, any unit; at most 8,000 triangles of it, evenly spread, are looked at
/// @par Cost A few milliseconds, whatever the size. Any thread. The same mesh gives the same answer.
[[nodiscard]] std::optional<Staircase> findStaircase(const TriangleMesh& mesh);

} // namespace palpate::geometry
