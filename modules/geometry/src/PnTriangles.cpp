// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/PnTriangles.h"

#include "palpate/geometry/EdgeTable.h"
#include "palpate/geometry/Reshape.h"

#include "repair/DisjointSets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace palpate::geometry {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
/// Facets with a vertex normal farther from their own than the angle of this cosine (60°) stay flat: the patch would
/// fold.
constexpr double kLeastCosine = 0.5;

/// Edge of a facet: the same object for both facets of a curved edge.
struct CurvedEdge
{
    std::uint32_t from = 0, to = 0; ///< vertices, from < to
    Vec3 nearFrom, nearTo;          ///< inner control points of the cubic curve
    std::uint32_t pieces = 1;
    std::uint32_t firstVertex = 0; ///< of the pieces - 1 new vertices, in the order from `from` to `to`
};

/// @return index k of the edge t[k], t[k + 1] that joins a and b
std::size_t edgeOf(const Triangle& t, std::uint32_t a, std::uint32_t b)
{
    for (std::size_t k = 0; k < 2; ++k) {
        const std::uint32_t p = t[k], q = t[k + 1];
        if ((p == a && q == b) || (p == b && q == a)) {
            return k;
        }
    }
    return 2;
}

std::size_t cornerOf(const Triangle& t, std::uint32_t vertex)
{
    return t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
}

double angleBetween(const Vec3& a, const Vec3& b)
{
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Inner control point of the curve from `p` to `other`, in the tangent plane at `p` (Vlachos et al., section 3).
Vec3 nearEnd(const Vec3& p, const Vec3& other, const Vec3& normal)
{
    return (2.0 * p + other - (other - p).dot(normal) * normal) / 3.0;
}

/// Triangulates the parameter domain of a facet whose edges have different numbers of pieces.
class FacetGrid
{
  public:
    /// @param pieces  of the edges 01, 12 and 20
    explicit FacetGrid(const std::array<std::uint32_t, 3>& pieces)
        : m_pieces(pieces)
        , m_most(*std::max_element(pieces.begin(), pieces.end()))
    {
    }

    /// Number of vertices inside the facet.
    [[nodiscard]] std::uint32_t innerVertices() const { return m_most < 3 ? 0 : (m_most - 1) * (m_most - 2) / 2; }

    [[nodiscard]] std::uint32_t triangles() const
    {
        const std::uint32_t edges = m_pieces[0] + m_pieces[1] + m_pieces[2];
        return edges - 2 + 2 * innerVertices(); // Euler: boundary vertices - 2 + 2 times the inner vertices
    }

    /// Calls `vertex(u)` with the barycentric coordinates of each inner vertex, in the order of their numbers.
    template<class F>
    void forEachInner(F&& vertex) const
    {
        for (std::uint32_t row = 1; row + 1 < m_most; ++row) {
            for (std::uint32_t i = 1; i + row < m_most; ++i) {
                vertex(Vec3(m_most - row - i, i, row) / static_cast<double>(m_most));
            }
        }
    }

    /// Calls `triangle(a, b, c)`. @param outer  vertices of the edge e in its direction, pieces + 1 each
    template<class F>
    void forEachTriangle(const std::array<std::vector<std::uint32_t>, 3>& outer, std::uint32_t firstInner,
                         F&& triangle) const
    {
        if (m_most < 3) {
            withoutInner(outer, triangle);
            return;
        }
        for (std::uint32_t row = 1; row + 2 < m_most; ++row) {
            for (std::uint32_t i = 1; i + row + 1 < m_most; ++i) {
                const auto at = [&](std::uint32_t x, std::uint32_t y) { return inner(firstInner, x, y); };
                triangle(at(i, row), at(i + 1, row), at(i, row + 1));
                if (i + row + 2 < m_most) {
                    triangle(at(i + 1, row), at(i + 1, row + 1), at(i, row + 1));
                }
            }
        }
        for (std::size_t e = 0; e < 3; ++e) {
            strip(outer[e], e, firstInner, triangle);
        }
    }

  private:
    /// Number of the inner vertex in column i (1 ...) of a row (1 ...), counted towards corners 1 and 2.
    [[nodiscard]] std::uint32_t inner(std::uint32_t first, std::uint32_t i, std::uint32_t row) const
    {
        // Row r has most - 1 - r vertices.
        return first + (row - 1) * (m_most - 1) - row * (row - 1) / 2 + (i - 1);
    }

    /// Fills the strip between an outer edge and the parallel row of inner vertices.
    template<class F>
    void strip(const std::vector<std::uint32_t>& outer, std::size_t e, std::uint32_t firstInner, F&& triangle) const
    {
        const std::uint32_t last = m_most - 2; // inner vertices on this side
        const auto at = [&](std::uint32_t k) { // k = 1 ... last, in the direction of the edge
            return e == 0   ? inner(firstInner, k, 1)
                   : e == 1 ? inner(firstInner, last + 1 - k, k)
                            : inner(firstInner, 1, last + 1 - k);
        };
        const std::uint32_t pieces = m_pieces[e];
        std::uint32_t p = 0, k = 1;
        while (p < pieces || k < last) {
            // Compares the middles of the next two pieces along the edge, (p + 1/2) / pieces and (k + 1) / most.
            const bool isOuter = k == last || (p < pieces && (2 * p + 1) * m_most <= (2 * k + 2) * pieces);
            if (isOuter) {
                triangle(outer[p], outer[p + 1], at(k));
                ++p;
            } else {
                triangle(outer[p], at(k + 1), at(k));
                ++k;
            }
        }
    }

    /// Divides a facet with at most two pieces per edge.
    template<class F>
    void withoutInner(const std::array<std::vector<std::uint32_t>, 3>& outer, F&& triangle) const
    {
        // Each divided edge cuts off the corner where it meets the next divided edge; the rest is a fan.
        std::vector<std::uint32_t> rest;
        for (std::size_t e = 0; e < 3; ++e) {
            const std::size_t before = (e + 2) % 3;
            if (m_pieces[before] == 2 && m_pieces[e] == 2) {
                triangle(outer[before][1], outer[e][0], outer[e][1]);
            } else {
                rest.push_back(outer[e][0]);
            }
            if (m_pieces[e] == 2) {
                rest.push_back(outer[e][1]);
            }
        }
        for (std::size_t i = 1; i + 1 < rest.size(); ++i) {
            triangle(rest[0], rest[i], rest[i + 1]);
        }
    }

    std::array<std::uint32_t, 3> m_pieces;
    std::uint32_t m_most;
};

class PnDivision
{
  public:
    PnDivision(const RepairedMesh& surface, const PnOptions& options)
        : m_surface(surface)
        , m_mesh(surface.mesh)
        , m_options(options)
    {
    }
    PnSurface run();

  private:
    void findNormals(const EdgeTable& edges);
    void keepSteepFacetsFlat();
    void curveEdges(const EdgeTable& edges, std::uint32_t mostPieces);
    [[nodiscard]] bool isCurved(const EdgeUse* uses, std::size_t count) const;
    [[nodiscard]] std::size_t countTriangles() const;
    void divide();
    [[nodiscard]] bool flattenFolds();
    void divideFacet(std::uint32_t triangle);
    [[nodiscard]] std::vector<std::uint32_t> alongEdge(std::uint32_t triangle, std::size_t k) const;
    [[nodiscard]] std::array<std::uint32_t, 3> piecesOf(std::uint32_t triangle) const
    {
        const auto& edges = m_edgesOf[triangle];
        return {m_edges[edges[0]].pieces, m_edges[edges[1]].pieces, m_edges[edges[2]].pieces};
    }
    void addVertex(const Vec3& p, const Triangle& corners, const Vec3& weights);

    const RepairedMesh& m_surface;
    const TriangleMesh& m_mesh;
    PnOptions m_options;
    std::vector<Vec3> m_facetNormals;
    std::vector<std::array<Vec3, 3>> m_normals; ///< at the corners of each triangle
    std::vector<std::uint8_t> m_isFlat;         ///< for each triangle
    std::vector<CurvedEdge> m_edges;
    std::vector<std::array<std::uint32_t, 3>> m_edgesOf; ///< edges 01, 12 and 20 of each triangle
    TriangleMesh m_out;
    std::vector<std::uint32_t> m_parents;
};

/// A smooth edge joins the corners of its two facets at both ends, so that both facets see the same two normals.
void PnDivision::findNormals(const EdgeTable& edges)
{
    const std::size_t n = m_mesh.triangles.size();
    m_facetNormals.resize(n);
    std::vector<std::array<Vec3, 3>> weighted(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Triangle& t = m_mesh.triangles[i];
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& p = m_mesh.vertices[t[k]];
            const Vec3 a = m_mesh.vertices[t[(k + 1) % 3]] - p, b = m_mesh.vertices[t[(k + 2) % 3]] - p;
            const Vec3 cross = a.cross(b);
            weighted[i][k] = cross / (a.squaredNorm() * b.squaredNorm()); // Max (1999), equation 2
            m_facetNormals[i] = k == 0 ? cross.normalized() : m_facetNormals[i];
        }
    }
    DisjointSets corners(3 * n);
    edges.forEach([&](const EdgeUse* uses, std::size_t count) {
        if (!isCurved(uses, count)) {
            return;
        }
        const std::uint32_t a = uses[0].triangle, b = uses[1].triangle;
        const Triangle &s = m_mesh.triangles[a], &t = m_mesh.triangles[b];
        const std::uint32_t other = uses[0].other;
        const std::size_t k = cornerOf(s, other);
        // The edge runs from its smaller vertex to `other`.
        const std::uint32_t smaller = uses[0].isForward ? s[(k + 2) % 3] : s[(k + 1) % 3];
        for (const std::uint32_t v : {smaller, other}) {
            corners.join(static_cast<std::uint32_t>(3 * a + cornerOf(s, v)),
                         static_cast<std::uint32_t>(3 * b + cornerOf(t, v)));
        }
    });
    std::vector<Vec3> sums(3 * n, Vec3::Zero());
    for (std::uint32_t c = 0; c < 3 * n; ++c) {
        sums[corners.find(c)] += weighted[c / 3][c % 3];
    }
    m_normals.resize(n);
    for (std::uint32_t c = 0; c < 3 * n; ++c) {
        const Vec3& sum = sums[corners.find(c)];
        const double length = sum.norm();
        m_normals[c / 3][c % 3] = length > 0.0 ? Vec3(sum / length) : m_facetNormals[c / 3];
    }
}

/// True for an edge of two facets on the same side of the surface that meet at less than the crease angle.
bool PnDivision::isCurved(const EdgeUse* uses, std::size_t count) const
{
    return count == 2 && uses[0].isForward != uses[1].isForward &&
           m_facetNormals[uses[0].triangle].dot(m_facetNormals[uses[1].triangle]) >=
               std::cos(m_options.crease_deg * kDegree);
}

void PnDivision::keepSteepFacetsFlat()
{
    m_isFlat.resize(m_mesh.triangles.size());
    for (std::size_t i = 0; i < m_isFlat.size(); ++i) {
        m_isFlat[i] = std::any_of(m_normals[i].begin(), m_normals[i].end(),
                                  [&](const Vec3& normal) { return !(normal.dot(m_facetNormals[i]) >= kLeastCosine); });
    }
}

void PnDivision::curveEdges(const EdgeTable& edges, std::uint32_t mostPieces)
{
    m_edges.clear();
    m_edgesOf.resize(m_mesh.triangles.size());
    edges.forEach([&](const EdgeUse* uses, std::size_t count) {
        const Triangle& t = m_mesh.triangles[uses[0].triangle];
        CurvedEdge edge;
        edge.to = uses[0].other;
        const std::size_t toCorner = cornerOf(t, edge.to);
        const std::size_t fromCorner = (toCorner + (uses[0].isForward ? 2 : 1)) % 3;
        edge.from = t[fromCorner];
        const Vec3 &p = m_mesh.vertices[edge.from], &q = m_mesh.vertices[edge.to];
        const bool isStraight = !isCurved(uses, count) || m_isFlat[uses[0].triangle] || m_isFlat[uses[1].triangle];
        if (isStraight) {
            edge.nearFrom = (2.0 * p + q) / 3.0;
            edge.nearTo = (p + 2.0 * q) / 3.0;
        } else {
            const Vec3 &n = m_normals[uses[0].triangle][fromCorner], &m = m_normals[uses[0].triangle][toCorner];
            edge.nearFrom = nearEnd(p, q, n);
            edge.nearTo = nearEnd(q, p, m);
            // The normals turn on a straight edge too, and the curve turns between equal normals if it is S-shaped.
            const double turn =
                std::max(angleBetween(n, m), angleBetween(edge.nearFrom - p, edge.nearTo - edge.nearFrom) +
                                                 angleBetween(edge.nearTo - edge.nearFrom, q - edge.nearTo));
            // A circular arc of length L and angle a is L a / 8 away from its chord; n pieces reduce that by n².
            const double bySag = std::sqrt((q - p).norm() * turn / (8.0 * m_options.sag_mm));
            const double needed = std::ceil(std::max(turn / (m_options.turn_deg * kDegree), bySag) - 1e-6);
            const double most =
                std::min(std::floor((q - p).norm() / m_options.leastPiece_mm), static_cast<double>(mostPieces));
            edge.pieces = static_cast<std::uint32_t>(std::max(1.0, std::min(needed, most)));
        }
        const auto number = static_cast<std::uint32_t>(m_edges.size());
        m_edges.push_back(edge);
        for (std::size_t i = 0; i < count; ++i) {
            m_edgesOf[uses[i].triangle][edgeOf(m_mesh.triangles[uses[i].triangle], edge.from, edge.to)] = number;
        }
    });
}

std::size_t PnDivision::countTriangles() const
{
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < m_mesh.triangles.size(); ++i) {
        count += FacetGrid(piecesOf(i)).triangles();
    }
    return count;
}

void PnDivision::addVertex(const Vec3& p, const Triangle& corners, const Vec3& weights)
{
    m_out.vertices.push_back(p);
    for (MeshArray& array : m_out.arrays) {
        if (!array.isPerTriangle) {
            double value = 0.0;
            for (std::size_t k = 0; k < 3; ++k) {
                const double weight = weights[static_cast<Eigen::Index>(k)];
                value += weight > 0.0 ? weight * double{array.values[corners[k]]} : 0.0;
            }
            array.values.push_back(static_cast<float>(value));
        }
    }
}

void PnDivision::divide()
{
    m_out.triangles.clear();
    m_parents.clear();
    m_out.vertices = m_mesh.vertices;
    m_out.arrays = m_mesh.arrays;
    for (MeshArray& array : m_out.arrays) {
        if (array.isPerTriangle) {
            array.values.clear();
        }
    }
    for (CurvedEdge& edge : m_edges) {
        edge.firstVertex = static_cast<std::uint32_t>(m_out.vertices.size());
        const Vec3 &p = m_mesh.vertices[edge.from], &q = m_mesh.vertices[edge.to];
        for (std::uint32_t i = 1; i < edge.pieces; ++i) {
            const double t = static_cast<double>(i) / edge.pieces, s = 1.0 - t;
            addVertex(s * s * s * p + 3.0 * s * t * (s * edge.nearFrom + t * edge.nearTo) + t * t * t * q,
                      {edge.from, edge.to, edge.to}, {s, t, 0.0});
        }
    }
    for (std::uint32_t i = 0; i < m_mesh.triangles.size(); ++i) {
        divideFacet(i);
    }
}

/// @return the vertices of edge k of a triangle in the triangle's direction
std::vector<std::uint32_t> PnDivision::alongEdge(std::uint32_t triangle, std::size_t k) const
{
    const CurvedEdge& edge = m_edges[m_edgesOf[triangle][k]];
    std::vector<std::uint32_t> along{edge.from};
    for (std::uint32_t i = 0; i + 1 < edge.pieces; ++i) {
        along.push_back(edge.firstVertex + i);
    }
    along.push_back(edge.to);
    if (m_mesh.triangles[triangle][k] != edge.from) {
        std::reverse(along.begin(), along.end());
    }
    return along;
}

void PnDivision::divideFacet(std::uint32_t triangle)
{
    const Triangle& t = m_mesh.triangles[triangle];
    const FacetGrid grid(piecesOf(triangle));
    const auto firstInner = static_cast<std::uint32_t>(m_out.vertices.size());
    std::array<Vec3, 3> corner, after, before; // control points behind and ahead of each corner
    Vec3 edgeMean = Vec3::Zero(), cornerMean = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
        corner[k] = m_mesh.vertices[t[k]];
        const CurvedEdge& edge = m_edges[m_edgesOf[triangle][k]];
        const bool isForward = edge.from == t[k];
        after[k] = isForward ? edge.nearFrom : edge.nearTo;
        before[(k + 1) % 3] = isForward ? edge.nearTo : edge.nearFrom;
        edgeMean += (edge.nearFrom + edge.nearTo) / 6.0;
        cornerMean += corner[k] / 3.0;
    }
    const Vec3 middle = edgeMean + (edgeMean - cornerMean) / 2.0; // b111 of Vlachos et al.
    grid.forEachInner([&](const Vec3& u) {
        Vec3 p = 6.0 * u.x() * u.y() * u.z() * middle;
        for (std::size_t k = 0; k < 3; ++k) {
            const double x = u[static_cast<Eigen::Index>(k)], y = u[static_cast<Eigen::Index>((k + 1) % 3)],
                         z = u[static_cast<Eigen::Index>((k + 2) % 3)];
            p += x * x * (x * corner[k] + 3.0 * y * after[k] + 3.0 * z * before[k]);
        }
        addVertex(p, t, u);
    });
    const std::size_t first = m_out.triangles.size();
    grid.forEachTriangle({alongEdge(triangle, 0), alongEdge(triangle, 1), alongEdge(triangle, 2)}, firstInner,
                         [this](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
                             m_out.triangles.push_back({a, b, c});
                         });
    const std::size_t added = m_out.triangles.size() - first;
    m_parents.insert(m_parents.end(), added, triangle);
    for (std::size_t i = 0; i < m_out.arrays.size(); ++i) {
        if (m_out.arrays[i].isPerTriangle) {
            std::vector<float>& values = m_out.arrays[i].values;
            values.insert(values.end(), added, m_mesh.arrays[i].values[triangle]);
        }
    }
}

/// Marks the facets of pieces that face away from their facet or have no area: repair would drop such pieces, which
/// opens the surface. @return true if there are any
bool PnDivision::flattenFolds()
{
    constexpr double kLeastHeight = 1e-6; // of a piece relative to its longest edge, far above rounding
    bool isAny = false;
    for (std::size_t i = 0; i < m_out.triangles.size(); ++i) {
        const Triangle& t = m_out.triangles[i];
        const Vec3 &a = m_out.vertices[t[0]], &b = m_out.vertices[t[1]], &c = m_out.vertices[t[2]];
        const double longest2 = std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (c - b).squaredNorm()});
        const std::uint32_t parent = m_parents[i];
        const bool isFold = !((b - a).cross(c - a).dot(m_facetNormals[parent]) > kLeastHeight * longest2);
        if (isFold && m_isFlat[parent] == 0) {
            m_isFlat[parent] = 1;
            isAny = true;
        }
    }
    return isAny;
}

PnSurface PnDivision::run()
{
    PnSurface out;
    const EdgeTable edges(m_mesh);
    findNormals(edges);
    keepSteepFacetsFlat();
    do { // ends, because each round keeps more facets flat
        curveEdges(edges, m_options.mostPieces);
        out.triangles = countTriangles();
        if (out.triangles > m_options.manyTriangles) {
            curveEdges(edges, m_options.mostPieces / 2);
            out.triangles = countTriangles();
        }
        out.isRefused = out.triangles > m_options.mostTriangles;
        if (!out.isRefused && out.triangles > m_mesh.triangles.size()) {
            divide();
        }
    } while (!out.isRefused && flattenFolds());
    out.flatTriangles = static_cast<std::size_t>(std::count(m_isFlat.begin(), m_isFlat.end(), std::uint8_t{1}));
    if (!out.isRefused && out.triangles > m_mesh.triangles.size()) {
        out.surface = withTriangles(m_surface, m_out, m_parents);
        out.triangles = out.surface->mesh.triangles.size();
    }
    return out;
}

} // namespace

PnSurface pnTriangles(const RepairedMesh& surface, const PnOptions& options)
{
    return PnDivision(surface, options).run();
}

} // namespace palpate::geometry
