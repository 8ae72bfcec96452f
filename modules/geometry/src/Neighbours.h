// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/SurfaceIndex.h"

namespace palpate::geometry {

/// Finds for each edge of each triangle the one other triangle there that is turned the same way.
/// @param surface  its triangles and vertices
/// @return for each triangle, by edge, `triangle << 2 | edge` of the other; kNoNeighbour << 2 where there is none or
///         more than one.
/// @par Cost O(n), on at most two threads; the result does not depend on their number.
[[nodiscard]] core::LargeArray<Triangle> findNeighbours(const SurfaceIndex& surface, unsigned threads);

} // namespace palpate::geometry
