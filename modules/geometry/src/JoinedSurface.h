// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/SurfaceIndex.h"

#include <span>

namespace palpate::geometry {

/// A surface in the order of its index, each triangle joined to its neighbours: what is needed to tell which triangles
/// are clear. A view: everything must outlive it.
struct JoinedSurface
{
    std::span<const Vec3> vertices;       ///< [mm]
    std::span<const Triangle> triangles;  ///< of vertices
    std::span<const Triangle> neighbours; ///< of each triangle, by edge: see findNeighbours
    const BoxHierarchy& hierarchy;        ///< of the triangles
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
