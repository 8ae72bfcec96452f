// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/TriangleMesh.h"

#include <palpate/core/LargeArray.h>

#include <cstdint>

namespace palpate::geometry {

/// Finds for each edge of each triangle the one other triangle there that is turned the same way.
/// @param triangles  corners in their lower 31 bits
/// @param found  set to `triangle << 2 | edge` for each edge; SurfaceIndex::kNoNeighbour << 2 where there is none or
///               more than one
/// @par Cost O(n), on at most two threads; the result does not depend on their number.
void findNeighbours(const core::LargeArray<Triangle>& triangles, std::uint32_t vertexCount, unsigned threads,
                    core::LargeArray<Triangle>& found);

} // namespace palpate::geometry
