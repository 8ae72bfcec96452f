// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/EdgeTable.h"

#include <cstdint>
#include <vector>

namespace palpate::geometry {

/// State of one component while its orientation is decided.
struct Component
{
    bool isConsistent = true;
    bool isOrientable = true;
    bool isBalanced = true; ///< every edge is traversed equally often in both directions
    double volume6 = 0.0;
    Box box;
    std::uint32_t someTriangle = 0;
};

/// Finds the triangles of inconsistent components to reverse so that neighbours across two-triangle edges agree.
/// Patches connected only by other edges keep the orientation of their majority.
/// @param components  `isOrientable` is set to false if no consistent orientation exists; such components are unchanged
/// @return the triangles to reverse
[[nodiscard]] std::vector<std::uint32_t> trianglesToReverse(std::size_t triangleCount, const EdgeTable& edges,
                                                            const std::vector<std::uint32_t>& componentOf,
                                                            std::vector<Component>& components);

} // namespace palpate::geometry
