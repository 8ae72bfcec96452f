// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceBuilder.h"

#include "ClearTriangles.h"
#include "Neighbours.h"

#include <palpate/core/Parallel.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate::geometry {

namespace {

constexpr std::size_t kMeshBlock = 16'384; // minimum number of triangles for a thread

/// Error bound of a plane distance, for points at distances up to about the triangle size: the error of the point's
/// coordinates plus the error of the normal, where the cross product is accurate to 2 eps times the squared longest
/// edge.
double planeDistanceError(double slenderest_mm2, double coordinate_mm)
{
    return 2.0 * std::numeric_limits<double>::epsilon() * (coordinate_mm + std::sqrt(slenderest_mm2));
}

} // namespace

SurfaceBuilder::Scale SurfaceBuilder::measure(const Box& bounds, core::LargeArray<BoxedItem>& items) const
{
    const TriangleMesh& mesh = m_repaired.mesh;
    const std::size_t count = mesh.triangles.size();
    const Vec3 origin = bounds.center();
    items.resize(count);
    core::LargeArray<double> doubledArea_mm2(count);
    std::vector<double> slenderest_mm2(count / kMeshBlock + 1,
                                       0.0); // (longest edge^3 / (2 * area))^2
    core::parallelForBlocks(
        count, kMeshBlock,
        [&](std::size_t i) {
            const Triangle& t = mesh.triangles[i];
            const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
            const Box box(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c));
            items[i] = BoxedItem(FloatBox::around(box, origin), static_cast<std::uint32_t>(i));
            const Vec3 ab = b - a, ac = c - a;
            const double longest2 = std::max({ab.squaredNorm(), ac.squaredNorm(), (c - b).squaredNorm()});
            const double area2 = ab.cross(ac).squaredNorm();
            double& slenderest = slenderest_mm2[i / kMeshBlock];
            slenderest = std::max(slenderest, longest2 * longest2 * longest2 / area2);
            doubledArea_mm2[i] = std::sqrt(area2);
        },
        m_threads);
    // Sum two halves in a fixed order, so that the result is bit-identical for any number of threads.
    double front_mm2 = 0.0, back_mm2 = 0.0;
    for (std::size_t i = 0, j = count / 2; j < count; ++i, ++j) {
        front_mm2 += i < count / 2 ? doubledArea_mm2[i] : 0.0;
        back_mm2 += doubledArea_mm2[j];
    }
    const double coordinate = std::max(bounds.min().cwiseAbs().maxCoeff(), bounds.max().cwiseAbs().maxCoeff());
    const double extent = bounds.diagonal().norm();
    const double worst =
        planeDistanceError(*std::max_element(slenderest_mm2.begin(), slenderest_mm2.end()), coordinate);
    Scale scale;
    // Eight times the maximum rounding error; at least 2^-40 of the extent (2e-10 mm for an organ of 200 mm), as a
    // margin for contact arithmetic; at most the imperceptible limit (god-object.md, "The skin"). 2.3e-16 is above eps.
    scale.skin_mm = std::min(
        {std::max(8.0 * worst, std::ldexp(extent, -40)), 1e-4, std::max(1e-6 * extent, 8.0 * 2.3e-16 * coordinate)});
    scale.isSkinAboveRounding = 8.0 * worst <= scale.skin_mm;
    // Edge length of an equilateral triangle of the mean area: doubled area divided by sin 60°, a factor of 2 /
    // sqrt(3).
    scale.facetSize_mm = std::sqrt((front_mm2 + back_mm2) / static_cast<double>(count) * 1.1547);
    return scale;
}

void SurfaceBuilder::reorder(const core::LargeArray<BoxedItem>& items, SurfaceIndex& index) const
{
    constexpr std::uint32_t kUnseen = 0xffffffffu;
    const TriangleMesh& mesh = m_repaired.mesh;
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
        index.m_triangles.push_back(t);
        index.m_sources.push_back(source);
    }
    index.m_vertexCount = static_cast<std::uint32_t>(index.m_vertices.size());
    index.m_vertices.push_back(Vec3::Zero());
}

void SurfaceBuilder::findParts(SurfaceIndex& index)
{
    constexpr std::uint32_t kUnseen = 0xffffffffu;
    std::vector<std::uint32_t> parts(index.m_triangles.size(), kUnseen), reached;
    std::uint32_t count = 0;
    for (std::uint32_t seed = 0; seed < parts.size(); ++seed) {
        if (parts[seed] != kUnseen) {
            continue;
        }
        parts[seed] = count;
        for (reached.assign(1, seed); !reached.empty();) {
            const std::uint32_t i = reached.back();
            reached.pop_back();
            for (const std::uint32_t beyond : index.m_neighbours[i]) {
                const std::uint32_t next = beyond >> 2;
                if (next != SurfaceIndex::kNoNeighbour && parts[next] == kUnseen) {
                    parts[next] = count;
                    reached.push_back(next);
                }
            }
        }
        ++count;
    }
    if (count > 1) {
        index.m_parts = std::move(parts);
    }
}

void SurfaceBuilder::flag(const std::vector<std::uint8_t>& isClear, SurfaceIndex& index) const
{
    constexpr std::uint32_t kFlagBit = SurfaceIndex::kFlagBit;
    core::parallelForBlocks(
        index.m_triangles.size(), kMeshBlock,
        [&](std::size_t i) {
            index.m_triangles[i][0] |= m_repaired.twoSided[index.m_sources[i]] != 0 ? kFlagBit : 0;
            if (isClear.empty()) {
                return;
            }
            index.m_triangles[i][1] |= isClear[i] != 0 ? kFlagBit : 0;
            for (std::uint32_t& beyond : index.m_neighbours[i]) {
                const std::uint32_t neighbour = beyond >> 2;
                beyond |= neighbour != SurfaceIndex::kNoNeighbour && isClear[neighbour] != 0 ? kFlagBit : 0;
            }
        },
        m_threads);
}

SurfaceIndex SurfaceBuilder::build()
{
    SurfaceIndex index;
    index.m_bounds = m_repaired.mesh.bounds();
    core::LargeArray<BoxedItem> items;
    const Scale scale = measure(index.m_bounds, items);
    index.m_skin_mm = scale.skin_mm;
    index.m_facetSize_mm = scale.facetSize_mm;
    index.m_hierarchy = BoxHierarchy::build(items, index.m_bounds.center(), m_threads);
    reorder(items, index);
    index.m_neighbours = findNeighbours(index.m_triangles, index.m_vertexCount, m_threads);
    findParts(index);
    std::vector<std::uint8_t> isClear;
    // With a skin below the rounding error of distances, no triangle can be proven clear.
    if (scale.isSkinAboveRounding) {
        isClear = findClear({std::span(index.m_vertices).first(index.m_vertexCount), index.m_triangles,
                             index.m_neighbours, index.m_hierarchy, index.m_bounds, index.m_skin_mm},
                            m_threads);
    }
    flag(isClear, index);
    return index;
}

} // namespace palpate::geometry
