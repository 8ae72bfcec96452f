// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/EdgeTable.h"

#include <cstdint>
#include <vector>

namespace palpate::geometry {

/// What is known of one component while its orientation is decided.
struct Component
{
    bool isConsistent = true;
    bool isOrientable = true;
    bool isBalanced = true; ///< every edge is traversed equally often in both directions
    double volume6 = 0.0;
    Box box;
    std::uint32_t someTriangle = 0;
};

/// Decides which triangles of the inconsistent components must turn round to agree with their neighbours over
/// two-triangle edges. Patches that only meet at other edges keep the facing of their majority.
/// @param components  `isOrientable` becomes false where no choice agrees; nothing is turned there
/// @return the triangles to turn round
[[nodiscard]] std::vector<std::uint32_t> trianglesToTurn(std::size_t triangleCount, const EdgeTable& edges,
                                                         const std::vector<std::uint32_t>& componentOf,
                                                         std::vector<Component>& components);

} // namespace palpate::geometry
