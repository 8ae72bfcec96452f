// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/SurfaceIndex.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate::geometry {

namespace {

/// Bound of the error of a plane distance computed from this triangle, for points about as near as it is large: that of
/// the point's own position, and that of the normal, whose cross product is off by less than 2 eps of the longest
/// edge's square.
double planeDistanceError(const Vec3& a, const Vec3& b, const Vec3& c, double coordinate)
{
    constexpr double kEps = std::numeric_limits<double>::epsilon();
    const Vec3 ab = b - a, ac = c - a;
    const double longest2 = std::max({ab.squaredNorm(), ac.squaredNorm(), (c - b).squaredNorm()});
    const double slenderness = longest2 / ab.cross(ac).norm();
    return 2.0 * kEps * (coordinate + std::sqrt(longest2) * slenderness);
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
    const Vec3 origin = index.m_bounds.center();
    const double coordinate =
        std::max(index.m_bounds.min().cwiseAbs().maxCoeff(), index.m_bounds.max().cwiseAbs().maxCoeff());
    const double extent = index.m_bounds.diagonal().norm();

    std::vector<FloatBox> boxes(mesh.triangles.size());
    double worst = 0.0, doubledArea = 0.0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        boxes[i] = FloatBox::around(Box(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)), origin);
        worst = std::max(worst, planeDistanceError(a, b, c, coordinate));
        doubledArea += (b - a).cross(c - a).norm();
    }
    // Eight times the worst rounding error, at least 2^-40 of the extent (2e-10 mm on an organ of 200 mm) so that the
    // arithmetic of contacts has room, at most what the design allows.
    index.m_skin_mm = std::min(
        {std::max(8.0 * worst, std::ldexp(extent, -40)), 1e-4, std::max(1e-6 * extent, 8.0 * 2.3e-16 * coordinate)});
    index.m_facetSize_mm = std::sqrt(doubledArea / static_cast<double>(mesh.triangles.size()) * 1.1547);

    core::LargeArray<std::uint32_t> order;
    index.m_hierarchy = BoxHierarchy::build(boxes, order, origin, threads);

    constexpr std::uint32_t kUnseen = 0xffffffffu;
    std::vector<std::uint32_t> renumbered(mesh.vertices.size(), kUnseen);
    index.m_vertices.reserve(mesh.vertices.size() + 1);
    index.m_triangles.resize(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Triangle& t = mesh.triangles[order[i]];
        for (std::size_t corner = 0; corner < 3; ++corner) {
            std::uint32_t& vertex = renumbered[t[corner]];
            if (vertex == kUnseen) {
                vertex = static_cast<std::uint32_t>(index.m_vertices.size());
                index.m_vertices.push_back(mesh.vertices[t[corner]]);
            }
            index.m_triangles[i][corner] = vertex;
        }
        if (repaired.twoSided[order[i]] != 0) {
            index.m_triangles[i][0] |= kTwoSidedBit;
        }
    }
    index.m_vertexCount = static_cast<std::uint32_t>(index.m_vertices.size());
    index.m_vertices.push_back(Vec3::Zero());
    index.m_sources = std::move(order);
    return index;
}

std::size_t SurfaceIndex::byteSize() const noexcept
{
    return m_vertices.capacity() * sizeof(Vec3) + m_triangles.capacity() * sizeof(Triangle) +
           m_sources.capacity() * sizeof(std::uint32_t) + m_hierarchy.byteSize();
}

} // namespace palpate::geometry
