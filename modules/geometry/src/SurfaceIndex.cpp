// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/SurfaceIndex.h"

#include "ClearTriangles.h"
#include "Neighbours.h"
#include "Together.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace palpate::geometry {

namespace {

/// What the skin and the facets' size follow from.
struct Extremes
{
    double slenderest_mm2 = 0.0; ///< longest edge times the edge squared over twice the area, squared
    double doubledArea_mm2 = 0.0;
};

/// Boxes the triangles first … last.
Extremes box(const TriangleMesh& mesh, const Vec3& origin, std::size_t first, std::size_t last, BoxedItem* items)
{
    Extremes result;
    for (std::size_t i = first; i < last; ++i) {
        const Triangle& t = mesh.triangles[i];
        const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        const Box bounds(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c));
        items[i] = BoxedItem(FloatBox::around(bounds, origin), static_cast<std::uint32_t>(i));
        const Vec3 ab = b - a, ac = c - a;
        const double longest2 = std::max({ab.squaredNorm(), ac.squaredNorm(), (c - b).squaredNorm()});
        const double area2 = ab.cross(ac).squaredNorm();
        result.slenderest_mm2 = std::max(result.slenderest_mm2, longest2 * longest2 * longest2 / area2);
        result.doubledArea_mm2 += std::sqrt(area2);
    }
    return result;
}

/// Bound of the error of a plane distance, for points about as near to a triangle as it is large: that of the point's
/// own position, and that of the normal, whose cross product is off by less than 2 eps of the longest edge's square.
double planeDistanceError(double slenderest_mm2, double coordinate_mm)
{
    return 2.0 * std::numeric_limits<double>::epsilon() * (coordinate_mm + std::sqrt(slenderest_mm2));
}

} // namespace

SurfaceIndex SurfaceIndex::build(const RepairedMesh& repaired, unsigned threads)
{
    const TriangleMesh& mesh = repaired.mesh;
    SurfaceIndex index;
    index.m_bounds = mesh.bounds();
    if (mesh.triangles.empty()) {
        return index;
    }
    if (const double half = 0.5 * index.m_bounds.sizes().maxCoeff(); !(half <= kLargest_mm)) {
        char text[160];
        std::snprintf(text, sizeof text, "a mesh of %.3g mm from its middle to its side; expected at most %.0e mm",
                      half, kLargest_mm);
        index.m_status = {core::StatusCode::OutOfRange, text};
        index.m_bounds.setEmpty();
        return index;
    }
    const Vec3 origin = index.m_bounds.center();
    const double coordinate =
        std::max(index.m_bounds.min().cwiseAbs().maxCoeff(), index.m_bounds.max().cwiseAbs().maxCoeff());
    const double extent = index.m_bounds.diagonal().norm();

    // In two halves whatever the number of threads: the sum has the same bits.
    core::LargeArray<BoxedItem> items(mesh.triangles.size());
    const std::size_t half = items.size() / 2;
    Extremes front, back;
    together(
        items.size() < kMany ? 1 : threads, [&] { front = box(mesh, origin, 0, half, items.data()); },
        [&] { back = box(mesh, origin, half, items.size(), items.data()); });
    const double worst = planeDistanceError(std::max(front.slenderest_mm2, back.slenderest_mm2), coordinate);
    const double doubledArea = front.doubledArea_mm2 + back.doubledArea_mm2;
    // Eight times the worst rounding error, at least 2^-40 of the extent (2e-10 mm on an organ of 200 mm) so that the
    // arithmetic of contacts has room, at most what the design allows.
    index.m_skin_mm = std::min(
        {std::max(8.0 * worst, std::ldexp(extent, -40)), 1e-4, std::max(1e-6 * extent, 8.0 * 2.3e-16 * coordinate)});
    index.m_facetSize_mm = std::sqrt(doubledArea / static_cast<double>(mesh.triangles.size()) * 1.1547);

    index.m_hierarchy = BoxHierarchy::build(items, origin, threads);

    constexpr std::uint32_t kUnseen = 0xffffffffu;
    std::vector<std::uint32_t> renumbered(mesh.vertices.size(), kUnseen);
    index.m_vertices.reserve(mesh.vertices.size() + 1);
    index.m_triangles.reserve(items.size());
    index.m_sources.reserve(items.size());
    constexpr std::size_t kAhead = 16;
    const auto later = [&](std::size_t i) -> const Triangle& {
        return mesh.triangles[items[std::min(i, items.size() - 1)].number];
    };
    for (std::size_t i = 0; i < items.size(); ++i) {
        core::prefetch(&later(i + 2 * kAhead));
        for (const std::uint32_t corner : later(i + kAhead)) {
            core::prefetch(&renumbered[corner]);
            core::prefetch(&mesh.vertices[corner]);
        }
        const std::uint32_t source = items[i].number;
        Triangle t = mesh.triangles[source];
        for (std::uint32_t& corner : t) {
            std::uint32_t& vertex = renumbered[corner];
            if (vertex == kUnseen) {
                vertex = static_cast<std::uint32_t>(index.m_vertices.size());
                index.m_vertices.push_back(mesh.vertices[corner]);
            }
            corner = vertex;
        }
        if (repaired.twoSided[source] != 0) {
            t[0] |= kFlagBit;
        }
        index.m_triangles.push_back(t);
        index.m_sources.push_back(source);
    }
    index.m_vertexCount = static_cast<std::uint32_t>(index.m_vertices.size());
    index.m_vertices.push_back(Vec3::Zero());
    index.m_neighbours = findNeighbours(index, threads);
    // With a skin below the rounding of distances nothing could be promised.
    if (8.0 * worst <= index.m_skin_mm) {
        const std::vector<std::uint8_t> isClear = findClear(index, threads);
        inHalves(index.triangleCount() < kMany ? 1 : threads, index.triangleCount(), [&](std::uint32_t i) {
            index.m_triangles[i][1] |= isClear[i] != 0 ? kFlagBit : 0;
            for (std::uint32_t& beyond : index.m_neighbours[i]) {
                const std::uint32_t neighbour = beyond >> 2;
                beyond |= neighbour != kNoNeighbour && isClear[neighbour] != 0 ? kFlagBit : 0;
            }
        });
    }
    return index;
}

std::size_t SurfaceIndex::byteSize() const noexcept
{
    return m_vertices.capacity() * sizeof(Vec3) + m_triangles.capacity() * sizeof(Triangle) +
           m_sources.capacity() * sizeof(std::uint32_t) + m_neighbours.capacity() * sizeof(Triangle) +
           m_hierarchy.byteSize();
}

} // namespace palpate::geometry
