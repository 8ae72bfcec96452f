// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/TriangleMesh.h"

#include <palpate/core/Export.h>
#include <palpate/core/Message.h>

#include <cstddef>
#include <vector>

namespace palpate::geometry {

/// Mesh quality of one structure: defects found and changes made by `repair`. All counts refer to this structure only.
struct PALPATE_EXPORT MeshReport
{
    std::size_t inputVertices = 0;
    std::size_t inputTriangles = 0;
    std::size_t vertices = 0;  ///< after repair
    std::size_t triangles = 0; ///< after repair

    std::size_t weldedVertices = 0;     ///< merged into another vertex: see RepairOptions::weldWithin_mm
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
    std::size_t turnedComponents = 0;        ///< inside-out components that `repair` turned (Facing::Outward)

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

} // namespace palpate::geometry
