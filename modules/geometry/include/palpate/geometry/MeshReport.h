// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/TriangleMesh.h"

#include <palpate/core/Message.h>

#include <cstddef>
#include <vector>

namespace palpate::geometry {

/// Mesh quality of one structure: defects found and changes made by `repair`. All counts refer to this structure only.
struct MeshReport
{
    std::size_t inputVertices = 0;
    std::size_t inputTriangles = 0;
    std::size_t vertices = 0;  ///< after repair
    std::size_t triangles = 0; ///< after repair

    std::size_t weldedVertices = 0;     ///< merged into another vertex with exactly the same coordinates
    std::size_t mixedValues = 0;        ///< merged array values with inputs more than 10 % apart
    std::size_t zeroAreaTriangles = 0;  ///< removed: the corners define no normal
    std::size_t duplicateTriangles = 0; ///< removed: same three vertices as another triangle, in any winding
    /// Edges of two triangles that both traverse in the same direction, before repair.
    std::size_t inconsistentEdges = 0;
    std::size_t reorientedTriangles = 0; ///< reversed to make an orientable component consistent

    std::size_t components = 0;              ///< sets of triangles connected by edges
    std::size_t openEdges = 0;               ///< edges of only one triangle
    std::size_t nonManifoldEdges = 0;        ///< edges of more than two triangles
    std::size_t closedComponents = 0;        ///< watertight: contact from the front side only
    std::size_t openComponents = 0;          ///< not watertight: contact from both sides
    std::size_t nonOrientableComponents = 0; ///< open components without a consistent orientation
    std::size_t insideOutComponents = 0;     ///< closed outermost components with normals that point inwards

    Box bounds; ///< [mm]
    double area_mm2 = 0.0;
    double volume_mm3 = 0.0; ///< signed volume of the closed components

    /// True if every component is closed and consistently oriented.
    [[nodiscard]] bool isClosed() const noexcept { return components > 0 && openComponents == 0; }
    /// True if nothing was changed and no defect was found.
    [[nodiscard]] bool isClean() const noexcept;
    /// Lists the findings, one sentence for each entry; empty if `isClean()`.
    [[nodiscard]] std::vector<core::Message> sentences() const;
};

/// Mesh that fulfils the preconditions of SurfaceIndex: all indices in range, no duplicate vertices, no zero-area or
/// duplicate triangles, and a consistent orientation of each orientable component.
struct RepairedMesh
{
    TriangleMesh mesh;
    /// For each triangle: 1 if the component is open, so that contact is possible from both sides.
    std::vector<std::uint8_t> twoSided;
    /// For each triangle: index in the input mesh. The corners keep their input order, so values at corners carry over
    /// directly, except where `turned` is set.
    std::vector<std::uint32_t> source;
    /// For each triangle: 1 if reversed, i.e. the second and third corner are swapped. Empty if no triangle is
    /// reversed.
    std::vector<std::uint8_t> turned;
    MeshReport report;
};

/// Repairs one structure's mesh for haptic rendering and reports the changes.
///
/// Arrays are carried over: a welded vertex gets the mean of the known values.
///
/// Welds vertices with equal coordinates, removes zero-area and duplicate triangles, and orients each component. A
/// consistent component keeps its orientation; an inconsistent but orientable component is made consistent (outwards if
/// closed). A component is closed if every edge is traversed equally often in both directions.
/// @pre all indices of `mesh` are in range and all coordinates are finite
/// @par Cost O(n log n). Any thread.
[[nodiscard]] RepairedMesh repair(const TriangleMesh& mesh);

} // namespace palpate::geometry
