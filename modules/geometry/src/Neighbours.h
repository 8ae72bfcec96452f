// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/TriangleMesh.h"

#include <palpate/core/LargeArray.h>

#include <span>

namespace palpate::geometry {

/// Finds the consistently oriented neighbour across each edge of each triangle.
/// @param vertexCount  above all vertex indices
/// @return for each triangle, by edge, `triangle << 2 | edge` of the neighbour; SurfaceIndex::kNoNeighbour << 2 without
/// a unique neighbour
/// @par Cost O(n), on at most `threads` threads; the result does not depend on their number.
[[nodiscard]] core::LargeArray<Triangle> findNeighbours(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                                                        unsigned threads);

} // namespace palpate::geometry
