// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/TriangleMesh.h"

#include <palpate/core/Export.h>

#include <cstddef>
#include <vector>

namespace palpate::geometry {

/// Hole of a surface: edges of only one triangle that are connected by vertices.
struct Hole
{
    std::size_t edges = 0;
    double across_mm = 0.0; ///< diagonal of the bounding box of its edges
};

/// Finds the holes of a surface, the largest first. Edges of more than two triangles are no holes.
/// @pre every index of `mesh` is in range
/// @par Cost O(n log n). Any thread.
[[nodiscard]] PALPATE_EXPORT std::vector<Hole> holesOf(const TriangleMesh& mesh);

} // namespace palpate::geometry
