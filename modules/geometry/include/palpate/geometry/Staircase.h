// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/TriangleMesh.h"

#include <palpate/core/Export.h>
#include <palpate/core/Message.h>

#include <Eigen/Core>

#include <cstddef>
#include <optional>

namespace palpate::geometry {

/// Voxel staircase of a surface extracted from a binary mask (label map) without smoothing. The god-object rests on
/// each step, and the force deviates from the force of the true surface by a factor.
struct PALPATE_EXPORT Staircase
{
    Vec3 voxel_mm = Vec3::Ones(); ///< voxel size along each of `axes` [mm], all > 0
    /// Columns: unit directions of the voxel edges; the first is nearest to x and so on.
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    bool isStated = false;  ///< voxels of a label map; otherwise detected in the surface
    double areaShare = 1.0; ///< fraction of the area in the kDirections most frequent normals (0 to 1)

    static constexpr int kDirections = 60; ///< normals within 1° count as the same direction

    /// Description: "staircase of about 1 × 1 × 3 mm voxels (97 % of the area in 60 directions)"
    [[nodiscard]] core::Message sentence() const;
};

/// Detects a surface extracted from a binary mask, from the geometry alone. Marching cubes puts every vertex halfway
/// along an edge of the voxel grid, which gives three criteria:
/// 1. Few normal directions cover most of the area. Measured fraction in 60 directions: masks 100 %, masks after
///    smoothing 2 to 5 %, segmented organs 3 to 10 %. Required: at least 50 %, and more than 60 triangles.
/// 2. Three of these directions are perpendicular, and along each the corners of a triangle are 0, one half or one
///    voxel apart. Voxel faces (corners 0 or one voxel apart) count as well. Required for at least 50 % of the area.
/// 3. The surface has steps: at least 15 % of the area is outside the outermost planes perpendicular to the axes, or
///    33 % if no edge is bevelled as in marching cubes. A box is entirely in these planes, however finely tessellated.
///
/// Facets larger than a voxel fail the second criterion: CAD parts whose edges happen to fit a grid are not detected.
/// @param mesh  welded or not, any unit; at most 8,000 evenly spread triangles are examined
/// @par Cost A few milliseconds, independent of the size. Any thread. Deterministic.
[[nodiscard]] PALPATE_EXPORT std::optional<Staircase> findStaircase(const TriangleMesh& mesh);

} // namespace palpate::geometry
