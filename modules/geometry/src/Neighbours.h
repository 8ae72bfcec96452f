// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/TriangleMesh.h"

#include <palpate/core/LargeArray.h>

#include <span>

namespace palpate::geometry {

/// Finds for each edge of each triangle the one other triangle there that is turned the same way.
/// @param vertexCount  more than any triangle's corner
/// @return for each triangle, by edge, `triangle << 2 | edge` of the other; SurfaceIndex::kNoNeighbour << 2 where there
///         is none or more than one.
/// @par Cost O(n), on at most `threads` threads; the result does not depend on their number.
[[nodiscard]] core::LargeArray<Triangle> findNeighbours(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                                                        unsigned threads);

} // namespace palpate::geometry
