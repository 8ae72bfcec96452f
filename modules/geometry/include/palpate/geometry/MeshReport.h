// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/TriangleMesh.h"

#include <cstddef>
#include <string>
#include <vector>

namespace palpate::geometry {

/// Health of one structure's surface: what `repair` found and what it changed. All counts are of the structure alone.
struct MeshReport
{
    std::size_t inputVertices = 0;
    std::size_t inputTriangles = 0;
    std::size_t vertices = 0;  ///< after repair
    std::size_t triangles = 0; ///< after repair

    std::size_t weldedVertices = 0;     ///< merged into another with exactly the same coordinates
    std::size_t mixedValues = 0;        ///< values of arrays that differed by more than 10 % where vertices were welded
    std::size_t zeroAreaTriangles = 0;  ///< dropped: no normal can be computed from their corners
    std::size_t duplicateTriangles = 0; ///< dropped: same three vertices as another, whatever the winding
    std::size_t inconsistentEdges = 0;  ///< two-triangle edges that both traverse in the same direction, before repair
    std::size_t reorientedTriangles = 0; ///< turned round to make an orientable component consistent

    std::size_t components = 0;              ///< sets of triangles connected over edges
    std::size_t openEdges = 0;               ///< edges with one triangle
    std::size_t nonManifoldEdges = 0;        ///< edges with more than two triangles
    std::size_t closedComponents = 0;        ///< have an inside: touched from their front only
    std::size_t openComponents = 0;          ///< have no inside: touched from both sides
    std::size_t nonOrientableComponents = 0; ///< of the open ones: no consistent orientation exists
    std::size_t insideOutComponents = 0;     ///< closed, outermost, but with normals that point inwards

    Box bounds; ///< [mm]
    double area_mm2 = 0.0;
    double volume_mm3 = 0.0; ///< signed, of the closed components

    /// Closed, one consistent surface everywhere.
    [[nodiscard]] bool isClosed() const noexcept { return components > 0 && openComponents == 0; }
    /// Nothing was changed and nothing stands out.
    [[nodiscard]] bool isClean() const noexcept;
    /// What was found, in words, one sentence an entry; empty when `isClean()`.
    [[nodiscard]] std::vector<std::string> sentences() const;
};

/// A mesh that the index can rely on: every index in range, no two vertices equal, no zero-area and no duplicate
/// triangle, each component consistently oriented where it can be.
struct RepairedMesh
{
    TriangleMesh mesh;
    /// One entry a triangle: 1 where its component has no inside and is touched from both sides.
    std::vector<std::uint8_t> twoSided;
    /// One entry a triangle: its index in the mesh that was given. Its corners are those of that triangle, in the same
    /// order, so that a value at a corner there is one here, but for what `turned` says.
    std::vector<std::uint32_t> source;
    /// One entry a triangle: 1 where it was turned round and its second and third corner have changed places. Empty
    /// when none was.
    std::vector<std::uint8_t> turned;
    MeshReport report;
};

/// Makes one structure's mesh fit for touching and reports what that took.
///
/// Arrays come along: a welded vertex has the mean of the values that are known there.
///
/// Welds vertices with equal coordinates, drops zero-area and duplicate triangles, and orients each component: a
/// consistent one keeps its orientation, an inconsistent but orientable one is made consistent (outwards when closed).
/// A component is closed when every edge is traversed equally often in both directions.
/// @pre every index of `mesh` is in range and every coordinate is finite
/// @par Cost O(n log n). Any thread.
[[nodiscard]] RepairedMesh repair(const TriangleMesh& mesh);

} // namespace palpate::geometry
