// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/LumpElements.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace palpate::evaluation {

/// Quadrilaterals of nine nodes that fill a half-space with a sphere in it, in a plane through the axis.
///
/// They are a rectangular grid in bispherical coordinates, in which the surface is eta = 0 and the sphere another
/// eta = constant: edges lie on both. The grid is graded towards the punch's rim and towards (0, 0), which is infinity;
/// the one cell there is left out, and its border is the far edge.
struct LumpGrid
{
    using Cell = std::array<std::size_t, 9>; ///< nodes row by row; the first three towards the surface

    std::vector<Eigen::Vector2d> nodes;                        ///< distance from the axis, depth [contact radii]
    std::vector<char> isOnAxis, isFar, isUnderPunch, isInLump; ///< of each node; the sphere's own are in the lump
    std::vector<Cell> cells;
    std::vector<char> isCellInLump;
    std::vector<std::array<std::size_t, 3>> surface; ///< edges of cells on the surface
};

/// @param sphereRadius, cover  > 0 [contact radii]
[[nodiscard]] LumpGrid lumpGrid(double sphereRadius, double cover, const LumpFineness& fineness);

} // namespace palpate::evaluation
