// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/SurfaceIndex.h"

#include <span>

namespace palpate::geometry {

/// View of a surface in index order with triangle adjacency: input for finding clear triangles. All referenced data
/// must outlive the view.
struct JoinedSurface
{
    std::span<const Vec3> vertices;       ///< [mm]
    std::span<const Triangle> triangles;  ///< vertex indices
    std::span<const Triangle> neighbours; ///< neighbours of each triangle, by edge: see findNeighbours
    const BoxHierarchy& hierarchy;        ///< over the triangles
    Box bounds;                           ///< [mm]
    double skin_mm;

    [[nodiscard]] std::uint32_t triangleCount() const noexcept { return static_cast<std::uint32_t>(triangles.size()); }
    [[nodiscard]] std::uint32_t vertexCount() const noexcept { return static_cast<std::uint32_t>(vertices.size()); }
    /// As SurfaceIndex::neighbour.
    [[nodiscard]] SurfaceIndex::Neighbour neighbour(std::uint32_t i, std::uint32_t edge) const noexcept
    {
        return {neighbours[i][edge] >> 2, neighbours[i][edge] & 3u};
    }
};

} // namespace palpate::geometry
