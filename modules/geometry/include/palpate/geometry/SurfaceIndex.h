// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/BoxHierarchy.h"
#include "palpate/geometry/MeshReport.h"

#include <palpate/core/Parallel.h>
#include <palpate/core/Realtime.h>
#include <palpate/core/Status.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate::geometry {

/// The haptic copy of one structure's surface: vertices, triangles and a bounding-volume hierarchy. Read-only once
/// built: any number of threads may query it.
///
/// Triangles are stored in the order of the hierarchy's leaves and vertices in the order of their first use, so that
/// what lies together on the surface lies together in memory.
class SurfaceIndex
{
  public:
    /// Builds the index in O(n log n) on at most `threads` threads; the result does not depend on their number.
    /// Never from the servo thread.
    /// @param repaired  a mesh from `repair`, in the world frame [mm]; at most 2^29 triangles
    /// @return without a triangle, and `status` says why, where the mesh is larger than kLargest_mm from its middle
    [[nodiscard]] static SurfaceIndex build(const RepairedMesh& repaired, unsigned threads = core::coreCount());

    /// Ok; or why nothing can be touched here.
    [[nodiscard]] const core::Status& status() const noexcept { return m_status; }
    /// Sums and differences of a few coordinates must be finite as floats, which hold 3.4e38. [mm]
    static constexpr double kLargest_mm = 1e36;

    [[nodiscard]] std::uint32_t triangleCount() const noexcept
    {
        return static_cast<std::uint32_t>(m_triangles.size());
    }
    [[nodiscard]] std::uint32_t vertexCount() const noexcept { return m_vertexCount; }
    /// From each vertex four numbers can be read, as two or four lanes do; the fourth means nothing.
    [[nodiscard]] const Vec3& vertex(std::uint32_t i) const noexcept { return m_vertices[i]; }
    /// @param i  position in the index's own order
    [[nodiscard]] Triangle triangle(std::uint32_t i) const noexcept
    {
        const Triangle& t = m_triangles[i];
        return {t[0] & kIndexMask, t[1] & kIndexMask, t[2]};
    }
    /// True when the triangle belongs to a surface without an inside.
    [[nodiscard]] bool isTwoSided(std::uint32_t i) const noexcept { return (m_triangles[i][0] & kFlagBit) != 0; }
    /// @return the triangle's number in the repaired mesh that the index was built from: its corners are this one's, in
    /// the same order, so that a value at a corner there is one here.
    [[nodiscard]] std::uint32_t sourceTriangle(std::uint32_t i) const noexcept { return m_sources[i]; }

    /// What lies beyond an edge of a triangle.
    struct Neighbour
    {
        std::uint32_t triangle; ///< position in the index's own order; kNoNeighbour: none
        std::uint32_t edge;     ///< the same edge's number there, 0 … 2
    };
    static constexpr std::uint32_t kNoNeighbour = 0x1fffffffu;
    /// @param edge  0 … 2: from the first, second, third corner to the next
    /// @return the one other triangle at that edge, if it is turned the same way; none at an open edge and where more
    /// than two meet.
    [[nodiscard]] Neighbour neighbour(std::uint32_t i, std::uint32_t edge) const noexcept
    {
        const std::uint32_t packed = m_neighbours[i][edge] & kIndexMask;
        return {packed >> 2, packed & 3u};
    }

    /// True when a god-object that moves over this triangle can be blocked by its three neighbours alone: no other
    /// triangle of this surface comes as near, and those three turn by at most 53 degrees. That holds on the sides that
    /// are touched, up to kClearHeight skins above the triangle and from kClearOfCorners skins off its corners on.
    /// False where it was not shown.
    [[nodiscard]] bool isClear(std::uint32_t i) const noexcept { return (m_triangles[i][1] & kFlagBit) != 0; }
    /// @return true when all three neighbours are there and clear.
    [[nodiscard]] bool isClearAround(std::uint32_t i) const noexcept
    {
        const Triangle& n = m_neighbours[i];
        return (n[0] & n[1] & n[2] & kFlagBit) != 0;
    }
    static constexpr double kClearHeight = 2.0;
    static constexpr double kClearOfCorners = 65536.0;
    static constexpr double kClearApart = 8.0;  ///< skins from a clear triangle to those that share no corner with it
    static constexpr float kClearTurned = 0.6f; ///< cosine of the angle to its neighbours, at least

    /// Asks for what will be read soon, without waiting for it: a triangle, or the neighbours of one that is clear.
    void prefetchTriangles(std::uint32_t i) const noexcept { core::prefetch(&m_triangles[i]); }
    void prefetchNeighbours(std::uint32_t i) const noexcept
    {
        for (std::uint32_t edge = 0; edge < 3; ++edge) {
            const std::uint32_t n = neighbour(i, edge).triangle;
            core::prefetch(&m_triangles[n]);
            core::prefetch(&m_neighbours[n]);
        }
    }

    /// The items of its leaves are positions of triangles.
    [[nodiscard]] const BoxHierarchy& hierarchy() const noexcept { return m_hierarchy; }
    [[nodiscard]] const Box& bounds() const noexcept { return m_bounds; } ///< [mm]
    /// Gap that a god-object keeps to this surface: above the rounding error of a plane distance, far below what can be
    /// felt; see resources/docs/god-object.md. [mm]
    [[nodiscard]] double skin_mm() const noexcept { return m_skin_mm; }
    /// Side of the equilateral triangle of mean area. [mm]
    [[nodiscard]] double facetSize_mm() const noexcept { return m_facetSize_mm; }
    /// What touch costs: bytes held by the containers of this copy.
    [[nodiscard]] std::size_t byteSize() const noexcept;

  private:
    friend class SurfaceBuilder;

    static constexpr std::uint32_t kFlagBit = 0x80000000u;
    static constexpr std::uint32_t kIndexMask = ~kFlagBit;

    core::LargeArray<Vec3> m_vertices; ///< and one more, so that four numbers can be read from the last
    std::uint32_t m_vertexCount = 0;
    core::LargeArray<Triangle> m_triangles; ///< flags the first index: two-sided; the second: clear
    core::LargeArray<std::uint32_t> m_sources;
    core::LargeArray<Triangle> m_neighbours; ///< by edge: triangle << 2 | its edge; flagged: clear
    BoxHierarchy m_hierarchy;
    Box m_bounds;
    double m_skin_mm = 0.0;
    double m_facetSize_mm = 0.0;
    core::Status m_status;
};

} // namespace palpate::geometry
