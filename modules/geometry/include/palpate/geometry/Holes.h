// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/Repair.h"
#include "palpate/geometry/TriangleMesh.h"

#include <palpate/core/Export.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace palpate::geometry {

/// Hole of a surface: a closed chain of edges, each of only one triangle. Chains that meet at a vertex are separate
/// holes.
struct Hole
{
    std::vector<std::uint32_t> vertices{}; ///< in the direction in which the triangles traverse the edges
    std::uint32_t triangle = 0;            ///< at the edge from the first vertex to the second
    double across_mm = 0.0;                ///< diagonal of the bounding box
};

/// Finds the holes of a surface, the largest first. Chains with an edge of more than two triangles, or of two triangles
/// with different orientations, are no holes.
/// @pre every index of `mesh` is in range
/// @par Cost O(n log n). Any thread.
[[nodiscard]] PALPATE_EXPORT std::vector<Hole> holesOf(const TriangleMesh& mesh);

/// Result of closing holes.
struct ClosedHoles
{
    RepairedMesh surface;
    std::size_t closed = 0;     ///< number of holes
    double largest_mm = 0.0;    ///< across the largest closed hole
    double addedArea_mm2 = 0.0; ///< of the new triangles
};

/// Closes the holes of a surface up to a size by triangles between the vertices of each hole, without new vertices: of
/// all such triangulations the one of least area, after Barequet & Sharir, *Filling gaps in the boundary of a
/// polyhedron* (1995). A flat cut becomes flat, and a curved hole is spanned like a stretched skin. Holes with more
/// than 400 edges are first divided at short chords. A new triangle has the source of a triangle at the border of the
/// hole, whose values it continues.
/// @param surface  result of `repair`
/// @param upTo_mm  largest `Hole::across_mm` to close
/// @return std::nullopt if there is no such hole, or none that can be closed without a third triangle at an edge
/// @par Cost O(k³) for a hole of k edges up to 400, and O(k²) for larger ones. Any thread.
[[nodiscard]] PALPATE_EXPORT std::optional<ClosedHoles> withHolesClosed(const RepairedMesh& surface, double upTo_mm);

} // namespace palpate::geometry
