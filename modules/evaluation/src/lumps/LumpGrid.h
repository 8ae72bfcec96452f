// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/LumpElements.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace palpate::evaluation {

/// Nine-node quadrilaterals that fill a half-space with an embedded sphere, in a plane through the axis.
///
/// The grid is rectangular in bispherical coordinates, in which the surface is eta = 0 and the sphere is another line
/// of constant eta, so element edges follow both. The grid is graded towards the rim of the punch and towards (0, 0),
/// the point at infinity; the single cell at that point is omitted, and its border is the far boundary.
struct LumpGrid
{
    using Cell = std::array<std::size_t, 9>; ///< node indices row by row; the first three are closest to the surface

    std::vector<Eigen::Vector2d> nodes;                        ///< distance from the axis, depth [contact radii]
    std::vector<char> isOnAxis, isFar, isUnderPunch, isInLump; ///< per node; nodes on the sphere belong to the lump
    std::vector<Cell> cells;
    std::vector<char> isCellInLump;
    std::vector<std::array<std::size_t, 3>> surface; ///< cell edges on the surface
};

/// @param sphereRadius, cover  > 0 [contact radii]
[[nodiscard]] LumpGrid lumpGrid(double sphereRadius, double cover, const LumpResolution& fineness);

} // namespace palpate::evaluation
