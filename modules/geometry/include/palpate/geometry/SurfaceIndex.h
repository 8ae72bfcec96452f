// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/BoxHierarchy.h"
#include "palpate/geometry/Repair.h"

#include <palpate/core/Export.h>
#include <palpate/core/Parallel.h>
#include <palpate/core/Realtime.h>
#include <palpate/core/Status.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate::geometry {

/// Haptic copy of one structure's surface: vertices, triangles and a bounding volume hierarchy. Read-only after
/// construction: any number of threads may query the index.
///
/// Triangles are stored in the order of the hierarchy's leaves, and vertices in the order of first use, so that
/// neighbours on the surface are close in memory.
///
///     const SurfaceIndex index = SurfaceIndex::build(repair(mesh));
///     if (index.status().isOk()) {
///         const bool isInOrgan = isInside(index, p_W); // Inside.h
///     }
class PALPATE_EXPORT SurfaceIndex
{
  public:
    /// Builds the index in O(n log n) on at most `threads` threads. The result does not depend on their number. Not for
    /// the servo thread.
    /// @param repaired  result of `repair`, in the world frame [mm]; at most 2^29 triangles
    /// @return an index without triangles, with the reason in `status`, if the mesh extends more than kLargest_mm from
    /// its centre
    [[nodiscard]] static SurfaceIndex build(const RepairedMesh& repaired, unsigned threads = core::coreCount());

    /// Ok, or the reason why this surface cannot be touched.
    [[nodiscard]] const core::Status& status() const noexcept { return m_status; }
    /// Largest half extent, so that sums and differences of a few coordinates remain finite as floats (up to 3.4e38).
    /// [mm]
    static constexpr double kLargest_mm = 1e36;

    [[nodiscard]] std::uint32_t triangleCount() const noexcept
    {
        return static_cast<std::uint32_t>(m_triangles.size());
    }
    [[nodiscard]] std::uint32_t vertexCount() const noexcept { return m_vertexCount; }
    /// @return vertex `i`. Four doubles can be loaded from this address as SIMD lanes; the fourth value is undefined.
    [[nodiscard]] const Vec3& vertex(std::uint32_t i) const noexcept { return m_vertices[i]; }
    /// @param i  position in the index's own order
    [[nodiscard]] Triangle triangle(std::uint32_t i) const noexcept
    {
        const Triangle& t = m_triangles[i];
        return {t[0] & kIndexMask, t[1] & kIndexMask, t[2]};
    }
    /// True if the triangle belongs to an open component.
    [[nodiscard]] bool isTwoSided(std::uint32_t i) const noexcept { return (m_triangles[i][0] & kFlagBit) != 0; }
    /// @return number of the triangle in the repaired mesh that the index was built from. The corners have the same
    /// order there, so values at corners carry over directly.
    [[nodiscard]] std::uint32_t sourceTriangle(std::uint32_t i) const noexcept { return m_sources[i]; }

    /// Triangle across an edge.
    struct Neighbour
    {
        std::uint32_t triangle; ///< position in the index's own order, or kNoNeighbour
        std::uint32_t edge;     ///< number of the shared edge in that triangle, 0 to 2
    };
    static constexpr std::uint32_t kNoNeighbour = 0x1fffffffu;
    /// @param edge  0 to 2: from the first, second, third corner to the next
    /// @return the other triangle at this edge if it is consistently oriented; kNoNeighbour at open and non-manifold
    /// edges
    [[nodiscard]] Neighbour neighbour(std::uint32_t i, std::uint32_t edge) const noexcept
    {
        const std::uint32_t packed = m_neighbours[i][edge] & kIndexMask;
        return {packed >> 2, packed & 3u};
    }

    /// Number of the connected part of the surface that the triangle belongs to. Parts are connected by `neighbour`.
    [[nodiscard]] std::uint32_t part(std::uint32_t i) const noexcept { return m_parts.empty() ? 0 : m_parts[i]; }
    [[nodiscard]] bool hasSeveralParts() const noexcept { return !m_parts.empty(); }

    /// True if only the three neighbours can block a god-object that slides over this triangle: no other triangle of
    /// this surface is as near, and the neighbours' normals turn by at most 53 degrees. Valid on the contact sides, up
    /// to kClearHeight skins above the triangle and at least kClearOfCorners skins away from its corners. False if
    /// unproven.
    [[nodiscard]] bool isClear(std::uint32_t i) const noexcept { return (m_triangles[i][1] & kFlagBit) != 0; }
    /// @return true if all three neighbours exist and are clear.
    [[nodiscard]] bool isClearAround(std::uint32_t i) const noexcept
    {
        const Triangle& n = m_neighbours[i];
        return (n[0] & n[1] & n[2] & kFlagBit) != 0;
    }
    static constexpr double kClearHeight = 2.0;
    static constexpr double kClearOfCorners = 65536.0;
    /// Distance from a clear triangle to triangles without a shared corner [skins].
    static constexpr double kClearSeparation = 8.0;
    /// Minimum cosine of the angle between a clear triangle's normal and its neighbours'.
    static constexpr float kClearMinCosine = 0.6f;

    /// Prefetches a triangle, or the neighbours of a clear triangle, without waiting.
    void prefetchTriangles(std::uint32_t i) const noexcept { core::prefetch(&m_triangles[i]); }
    void prefetchNeighbours(std::uint32_t i) const noexcept
    {
        for (std::uint32_t edge = 0; edge < 3; ++edge) {
            const std::uint32_t n = neighbour(i, edge).triangle;
            core::prefetch(&m_triangles[n]);
            core::prefetch(&m_neighbours[n]);
        }
    }

    /// Bounding volume hierarchy; its items are triangle positions in this index.
    [[nodiscard]] const BoxHierarchy& hierarchy() const noexcept { return m_hierarchy; }
    [[nodiscard]] const Box& bounds() const noexcept { return m_bounds; } ///< [mm]
    /// Gap between the god-object and this surface: above the rounding error of a plane distance, far below the
    /// perceptible range; see docs/god-object.md. [mm]
    [[nodiscard]] double skin_mm() const noexcept { return m_skin_mm; }
    /// Edge length of the equilateral triangle with the mean facet area. [mm]
    [[nodiscard]] double facetSize_mm() const noexcept { return m_facetSize_mm; }
    /// Memory of the haptic copy: bytes allocated by its containers.
    [[nodiscard]] std::size_t byteSize() const noexcept;

  private:
    friend class SurfaceBuilder;

    static constexpr std::uint32_t kFlagBit = 0x80000000u;
    static constexpr std::uint32_t kIndexMask = ~kFlagBit;

    core::LargeArray<Vec3>
        m_vertices; ///< with one extra element, so that four doubles can be loaded from the last vertex
    std::uint32_t m_vertexCount = 0;
    core::LargeArray<Triangle> m_triangles; ///< flag bit in the first index: two-sided; in the second: clear
    core::LargeArray<std::uint32_t> m_sources;
    core::LargeArray<Triangle>
        m_neighbours; ///< for each edge: triangle << 2 | shared edge there; flag bit: that neighbour is clear
    std::vector<std::uint32_t> m_parts; ///< empty for a surface of one part
    BoxHierarchy m_hierarchy;
    Box m_bounds;
    double m_skin_mm = 0.0;
    double m_facetSize_mm = 0.0;
    core::Status m_status;
};

} // namespace palpate::geometry
