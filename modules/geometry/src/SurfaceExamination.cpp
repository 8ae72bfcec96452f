// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/SurfaceExamination.h"

#include "palpate/geometry/internal/BoxHierarchyVisit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace palpate::geometry {

namespace {

using Corners = std::array<Vec3, 3>;

Corners cornersOf(const SurfaceIndex& surface, const Triangle& t)
{
    return {surface.vertex(t[0]), surface.vertex(t[1]), surface.vertex(t[2])};
}

bool shareVertex(const Triangle& a, const Triangle& b)
{
    return std::any_of(a.begin(), a.end(),
                       [&b](std::uint32_t v) { return std::find(b.begin(), b.end(), v) != b.end(); });
}

/// Six times the signed volume of tetrahedron a b c d.
double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    return (b - a).cross(c - a).dot(d - a);
}

/// @return true if the segment from p to q crosses the triangle from one side to the other; the triangle's edges are
/// included, because voxel surfaces meet edge on edge
bool passesThrough(const Vec3& p, const Vec3& q, const Corners& t)
{
    const double from = volume(t[0], t[1], t[2], p);
    const double to = volume(t[0], t[1], t[2], q);
    if (!(from * to < 0.0)) {
        return false;
    }
    const double u = volume(p, q, t[0], t[1]);
    const double v = volume(p, q, t[1], t[2]);
    const double w = volume(p, q, t[2], t[0]);
    return (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
}

bool cross(const Corners& a, const Corners& b)
{
    // The intersection of two triangles is a segment whose end points are each on an edge of one of the triangles.
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        if (passesThrough(a[k], a[next], b) || passesThrough(b[k], b[next], a)) {
            return true;
        }
    }
    return false;
}

void countCrossings(const SurfaceIndex& surface, std::size_t mostPairs, SurfaceExamination& out)
{
    std::size_t pairs = 0;
    for (std::uint32_t i = 0; i < surface.triangleCount(); ++i) {
        const Triangle one = surface.triangle(i);
        const Corners corners = cornersOf(surface, one);
        core::Box box;
        for (const Vec3& p : corners) {
            box.extend(p);
        }
        surface.hierarchy().visitBox(box, [&](std::uint32_t first, std::uint32_t count) {
            for (std::uint32_t j = std::max(first, i + 1); j < first + count; ++j) {
                const Triangle other = surface.triangle(j);
                if (!shareVertex(one, other)) {
                    ++pairs;
                    out.crossingPairs += cross(corners, cornersOf(surface, other)) ? 1 : 0;
                }
            }
            return pairs < mostPairs;
        });
        if (pairs >= mostPairs) {
            out.isPairLimitReached = true;
            return;
        }
        ++out.examinedTriangles;
    }
}

/// @return fraction of the segment at the first opposite wall, or 1
double wallAlong(const SurfaceIndex& surface, const Triangle& own, const Vec3& from, const Vec3& to, const Vec3& n)
{
    constexpr double kOpposite = -0.5; // cosine of 120° between the normals
    double nearest = 1.0;
    surface.hierarchy().visitSegment(from, to, [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t j = first; j < first + count; ++j) {
            const Triangle other = surface.triangle(j);
            const Corners t = cornersOf(surface, other);
            const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
            if (shareVertex(own, other) || !(normal.dot(n) < kOpposite * normal.norm()) ||
                !passesThrough(from, to, t)) {
                continue;
            }
            nearest = std::min(nearest, normal.dot(t[0] - from) / normal.dot(to - from));
        }
        return nearest;
    });
    return nearest;
}

void measureWall(const SurfaceIndex& surface, std::size_t samples, SurfaceExamination& out)
{
    const double reach = surface.bounds().sizes().norm();
    const std::uint32_t triangles = surface.triangleCount();
    const std::size_t count = std::min<std::size_t>(samples, triangles);
    for (std::size_t s = 0; s < count; ++s) {
        const auto i = static_cast<std::uint32_t>(s * triangles / count);
        if (surface.isTwoSided(i)) {
            continue;
        }
        const Triangle own = surface.triangle(i);
        const Corners t = cornersOf(surface, own);
        const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
        const Vec3 from = (t[0] + t[1] + t[2]) / 3.0;
        const double share = wallAlong(surface, own, from, from - reach * n, n);
        if (share < 1.0) {
            ++out.wallSamples;
            const double wall = share * reach;
            if (!out.thinnestWall_mm || wall < *out.thinnestWall_mm) {
                out.thinnestWall_mm = wall;
                out.thinnestAt = from;
            }
        }
    }
}

} // namespace

SurfaceExamination examine(const SurfaceIndex& surface, const ExaminationLimits& bounds)
{
    SurfaceExamination out;
    countCrossings(surface, bounds.pairs, out);
    measureWall(surface, bounds.samples, out);
    return out;
}

} // namespace palpate::geometry
