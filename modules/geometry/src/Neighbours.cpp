// SPDX-License-Identifier: BSD-3-Clause
#include "Neighbours.h"

#include "Together.h"

#include <algorithm>
#include <vector>

namespace palpate::geometry {

namespace {

constexpr std::uint32_t kNone = SurfaceIndex::kNoNeighbour << 2;

/// An edge, kept with the smaller of its vertices.
struct Edge
{
    std::uint32_t larger; ///< vertex << 1, and 1 where the triangle goes from the smaller to the larger
    std::uint32_t where;  ///< triangle << 2 | edge, of the triangle that came first
    std::uint32_t next;   ///< of the same smaller vertex; kNone at the end
};

/// Joins the triangles at those edges whose smaller vertex is first … last.
void join(const SurfaceIndex& surface, std::uint32_t first, std::uint32_t last, core::LargeArray<Triangle>& found)
{
    std::vector<std::uint32_t> newest(last - first, kNone);
    core::LargeArray<Edge> edges;
    edges.reserve(2 * std::size_t{surface.triangleCount()});
    for (std::uint32_t i = 0; i < surface.triangleCount(); ++i) {
        const Triangle t = surface.triangle(i);
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[k == 2 ? 0 : k + 1];
            const std::uint32_t smaller = std::min(a, b);
            if (smaller < first || smaller >= last) {
                continue;
            }
            const std::uint32_t larger = std::max(a, b) << 1 | (a < b ? 1u : 0u), where = i << 2 | k;
            std::uint32_t& head = newest[smaller - first];
            std::uint32_t at = head;
            while (at != kNone && edges[at].larger >> 1 != larger >> 1) {
                at = edges[at].next;
            }
            std::uint32_t& mine = found[i][k];
            if (at == kNone) {
                mine = kNone;
                edges.push_back({larger, where, head});
                head = static_cast<std::uint32_t>(edges.size() - 1);
                continue;
            }
            Edge& edge = edges[at];
            if (edge.where == kNone) {
                mine = kNone; // more than two
                continue;
            }
            std::uint32_t& other = found[edge.where >> 2][edge.where & 3u];
            if (edge.larger == larger || other != kNone) {
                if (other != kNone) {
                    found[other >> 2][other & 3u] = kNone;
                }
                mine = other = edge.where = kNone; // turned over, or the third
                continue;
            }
            mine = edge.where;
            other = where;
        }
    }
}

} // namespace

core::LargeArray<Triangle> findNeighbours(const SurfaceIndex& surface, unsigned threads)
{
    core::LargeArray<Triangle> found(surface.triangleCount());
    const std::uint32_t half = surface.vertexCount() / 2;
    together(
        found.size() < kMany ? 1 : threads, [&] { join(surface, 0, half, found); },
        [&] { join(surface, half, surface.vertexCount(), found); });
    return found;
}

} // namespace palpate::geometry
