// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/Holes.h"

#include "palpate/geometry/EdgeTable.h"
#include "palpate/geometry/Reshape.h"
#include "palpate/geometry/SurfaceIndex.h"

#include "Neighbours.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

namespace palpate::geometry {

namespace {

using VertexPair = std::pair<std::uint32_t, std::uint32_t>;

VertexPair pairOf(std::uint32_t a, std::uint32_t b)
{
    return {std::min(a, b), std::max(a, b)};
}

/// Chains of the edges at which no other triangle continues the surface.
class BorderChains
{
  public:
    explicit BorderChains(const TriangleMesh& mesh)
        : m_mesh(mesh)
        , m_neighbours(findNeighbours(mesh.triangles, static_cast<std::uint32_t>(mesh.vertices.size()), 1))
        , m_border(mesh.triangles.size())
        , m_isDone(mesh.triangles.size())
        , m_placeOf(mesh.vertices.size(), kNowhere)
    {
        EdgeTable(mesh).forEach([&](const EdgeUse* uses, std::size_t count) {
            if (count == 1) {
                m_border[uses->triangle][edgeOf(*uses)] = true;
            }
        });
    }
    std::vector<Hole> holes()
    {
        for (std::uint32_t t = 0; t < m_mesh.triangles.size(); ++t) {
            for (std::uint32_t edge = 0; edge < 3; ++edge) {
                if (m_border[t][edge] && !m_isDone[t][edge]) {
                    trace(t, edge);
                }
            }
        }
        std::stable_sort(m_holes.begin(), m_holes.end(),
                         [](const Hole& a, const Hole& b) { return a.across_mm > b.across_mm; });
        return std::move(m_holes);
    }

  private:
    static constexpr std::uint32_t kNowhere = 0xffffffffU;
    struct Link
    {
        std::uint32_t vertex, triangle;
        bool isBorder;
    };

    std::size_t edgeOf(const EdgeUse& use) const
    {
        const Triangle& t = m_mesh.triangles[use.triangle];
        std::size_t edge = 0;
        while (std::max(t[edge], t[(edge + 1) % 3]) != use.other || (t[edge] < t[(edge + 1) % 3]) != use.isForward) {
            ++edge;
        }
        return edge;
    }

    /// Follows the border from an edge until it returns there.
    void trace(std::uint32_t triangle, std::uint32_t edge)
    {
        std::vector<Link> chain;
        while (!m_isDone[triangle][edge]) {
            m_isDone[triangle][edge] = true;
            add(chain, {m_mesh.triangles[triangle][edge], triangle, m_border[triangle][edge]});
            // The next edge of the border, around the vertex at the end of this one.
            std::uint32_t next = (edge + 1) % 3;
            while (m_neighbours[triangle][next] >> 2 != SurfaceIndex::kNoNeighbour) {
                const std::uint32_t beyond = m_neighbours[triangle][next];
                triangle = beyond >> 2;
                next = ((beyond & 3U) + 1) % 3;
            }
            edge = next;
        }
        take(chain, 0);
    }

    /// Adds a link. A vertex that is in the chain already ends a hole.
    void add(std::vector<Link>& chain, const Link& link)
    {
        if (const std::uint32_t place = m_placeOf[link.vertex]; place != kNowhere) {
            take(chain, place);
        }
        m_placeOf[link.vertex] = static_cast<std::uint32_t>(chain.size());
        chain.push_back(link);
    }

    /// Moves the end of a chain to the holes.
    void take(std::vector<Link>& chain, std::size_t first)
    {
        Hole hole;
        Box box;
        bool isHole = true;
        for (std::size_t i = first; i < chain.size(); ++i) {
            m_placeOf[chain[i].vertex] = kNowhere;
            hole.vertices.push_back(chain[i].vertex);
            box.extend(m_mesh.vertices[chain[i].vertex]);
            isHole = isHole && chain[i].isBorder;
        }
        if (isHole && hole.vertices.size() > 2) {
            hole.triangle = chain[first].triangle;
            hole.across_mm = box.diagonal().norm();
            m_holes.push_back(std::move(hole));
        }
        chain.resize(first);
    }

    const TriangleMesh& m_mesh;
    core::LargeArray<Triangle> m_neighbours;
    std::vector<std::array<bool, 3>> m_border, m_isDone; ///< by triangle and edge
    std::vector<std::uint32_t> m_placeOf;                ///< of each vertex in the current chain
    std::vector<Hole> m_holes;
};

/// Spans a hole by triangles.
class Cap
{
  public:
    Cap(const TriangleMesh& mesh, const Hole& hole, const std::set<VertexPair>& taken)
        : m_mesh(mesh)
        , m_hole(hole)
        , m_taken(taken)
    {
    }
    /// @return false if each triangulation needs an edge that exists or a triangle without area
    bool span()
    {
        std::vector<std::uint32_t> places(m_hole.vertices.size());
        std::iota(places.begin(), places.end(), 0U);
        return spanParts(places);
    }
    [[nodiscard]] const std::vector<Triangle>& triangles() const noexcept { return m_triangles; }

  private:
    static constexpr std::size_t kMostEdges = 400;
    static constexpr double kNever = std::numeric_limits<double>::infinity();

    [[nodiscard]] std::uint32_t vertexAt(std::uint32_t place) const { return m_hole.vertices[place]; }
    [[nodiscard]] bool isFree(std::uint32_t a, std::uint32_t b) const
    {
        return m_taken.count(pairOf(vertexAt(a), vertexAt(b))) == 0;
    }
    /// Area and, so that the triangles of a flat hole are no slivers, a small share of the squared edges. [mm2]
    [[nodiscard]] double costOf(std::uint32_t a, std::uint32_t b, std::uint32_t c) const
    {
        constexpr double kEdges = 1e-3, kNoArea = 1e-12;
        const Vec3 &p = m_mesh.vertices[vertexAt(a)], &q = m_mesh.vertices[vertexAt(b)],
                   &r = m_mesh.vertices[vertexAt(c)];
        const double edges_mm2 = (q - p).squaredNorm() + (r - q).squaredNorm() + (p - r).squaredNorm();
        const double area_mm2 = 0.5 * (q - p).cross(r - p).norm();
        return area_mm2 > kNoArea * edges_mm2 ? area_mm2 + kEdges * edges_mm2 : kNever;
    }

    /// Divides a polygon with many corners at the shortest chord that leaves at least a third of them on either side.
    bool spanParts(const std::vector<std::uint32_t>& places)
    {
        const std::size_t count = places.size();
        if (count <= kMostEdges) {
            return spanPolygon(places);
        }
        std::size_t first = 0, last = 0;
        double shortest_mm = kNever;
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t j = i + count / 3; j < std::min(count, i + count - count / 3); ++j) {
                const double long_mm =
                    (m_mesh.vertices[vertexAt(places[i])] - m_mesh.vertices[vertexAt(places[j])]).norm();
                if (long_mm < shortest_mm && isFree(places[i], places[j])) {
                    shortest_mm = long_mm;
                    first = i;
                    last = j;
                }
            }
        }
        if (!(shortest_mm < kNever)) {
            return false;
        }
        const auto at = [&](std::size_t i) { return places.begin() + static_cast<std::ptrdiff_t>(i); };
        const std::vector<std::uint32_t> inner(at(first), at(last + 1));
        std::vector<std::uint32_t> outer(at(last), places.end());
        outer.insert(outer.end(), places.begin(), at(first + 1));
        return spanParts(inner) && spanParts(outer);
    }

    /// Finds the cheapest triangulation of a polygon between each two corners, from near ones to distant ones.
    bool spanPolygon(const std::vector<std::uint32_t>& places)
    {
        const std::size_t count = places.size();
        std::vector<double> cost(count * count, 0.0);
        std::vector<std::uint32_t> middle(count * count, 0);
        for (std::size_t apart = 2; apart < count; ++apart) {
            for (std::size_t i = 0; i + apart < count; ++i) {
                const std::size_t j = i + apart;
                double& best = cost[i * count + j];
                best = kNever;
                if (apart + 1 < count && !isFree(places[i], places[j])) {
                    continue;
                }
                for (std::size_t k = i + 1; k < j; ++k) {
                    const double inner = cost[i * count + k] + cost[k * count + j];
                    if (inner < best) {
                        if (const double all = inner + costOf(places[i], places[k], places[j]); all < best) {
                            best = all;
                            middle[i * count + j] = static_cast<std::uint32_t>(k);
                        }
                    }
                }
            }
        }
        if (!(cost[count - 1] < kNever)) {
            return false;
        }
        std::vector<std::pair<std::size_t, std::size_t>> open{{0, count - 1}};
        while (!open.empty()) {
            const auto [i, j] = open.back();
            open.pop_back();
            if (j - i < 2) {
                continue;
            }
            const std::size_t k = middle[i * count + j];
            // Against the direction of the border, which the surface follows.
            m_triangles.push_back({vertexAt(places[j]), vertexAt(places[k]), vertexAt(places[i])});
            open.emplace_back(i, k);
            open.emplace_back(k, j);
        }
        return true;
    }

    const TriangleMesh& m_mesh;
    const Hole& m_hole;
    const std::set<VertexPair>& m_taken;
    std::vector<Triangle> m_triangles;
};

/// Edges between vertices of holes.
std::set<VertexPair> edgesAt(const TriangleMesh& mesh, const std::vector<Hole>& holes)
{
    std::vector<bool> isAtHole(mesh.vertices.size());
    for (const Hole& hole : holes) {
        for (const std::uint32_t v : hole.vertices) {
            isAtHole[v] = true;
        }
    }
    std::set<VertexPair> edges;
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (isAtHole[t[k]] && isAtHole[t[(k + 1) % 3]]) {
                edges.insert(pairOf(t[k], t[(k + 1) % 3]));
            }
        }
    }
    return edges;
}

} // namespace

std::vector<Hole> holesOf(const TriangleMesh& mesh)
{
    return mesh.triangles.empty() ? std::vector<Hole>() : BorderChains(mesh).holes();
}

std::optional<ClosedHoles> withHolesClosed(const RepairedMesh& surface, double upTo_mm)
{
    const std::vector<Hole> holes = holesOf(surface.mesh);
    std::set<VertexPair> edges = edgesAt(surface.mesh, holes);
    TriangleMesh mesh = surface.mesh;
    std::vector<std::uint32_t> parents(mesh.triangles.size());
    std::iota(parents.begin(), parents.end(), 0U);
    ClosedHoles result;
    for (const Hole& hole : holes) {
        Cap cap(mesh, hole, edges);
        if (hole.across_mm > upTo_mm || !cap.span()) {
            continue;
        }
        for (const Triangle& t : cap.triangles()) {
            mesh.triangles.push_back(t);
            parents.push_back(hole.triangle);
            result.addedArea_mm2 +=
                0.5 *
                (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).norm();
            for (std::size_t k = 0; k < 3; ++k) {
                edges.insert(pairOf(t[k], t[(k + 1) % 3]));
            }
        }
        ++result.closed;
        result.largest_mm = std::max(result.largest_mm, hole.across_mm);
    }
    if (result.closed == 0) {
        return std::nullopt;
    }
    for (MeshArray& array : mesh.arrays) {
        for (std::size_t i = array.values.size(); array.isPerTriangle && i < mesh.triangles.size(); ++i) {
            array.values.push_back(array.values[parents[i]]);
        }
    }
    result.surface = withTriangles(surface, mesh, parents);
    return result;
}

} // namespace palpate::geometry
