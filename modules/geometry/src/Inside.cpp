// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/Inside.h"

#include "palpate/geometry/internal/BoxHierarchyVisit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace palpate::geometry {

namespace {

/// True if a ray to the outside crosses an odd number of walls.
/// @param walls  scratch buffer
bool hasOddCrossings(const SurfaceIndex& surface, const Vec3& p, const Vec3& d, std::vector<double>& walls)
{
    const Box& box = surface.bounds();
    const double size = box.diagonal().norm();
    const double reach = 1.01 * ((box.center() - p).norm() + size);
    walls.clear();
    surface.hierarchy().visitSegment(p, p + reach * d, [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t i = first; i < first + count; ++i) {
            const Triangle t = surface.triangle(i);
            const double at = distanceAlongRay(surface.vertex(t[0]), surface.vertex(t[1]), surface.vertex(t[2]), p, d);
            if (at < reach) {
                walls.push_back(at);
            }
        }
        return 1.0;
    });
    std::sort(walls.begin(), walls.end());
    // A ray through a shared edge hits both neighbours: merge them to one wall.
    const double apart = 1e-9 * (size + p.norm());
    const auto last = std::unique(walls.begin(), walls.end(), [apart](double a, double b) { return b - a <= apart; });
    return (last - walls.begin()) % 2 == 1;
}

} // namespace

double distanceAlongRay(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p, const Vec3& d) noexcept
{
    const double kMiss = std::numeric_limits<double>::infinity();
    const Vec3 u = b - a;
    const Vec3 v = c - a;
    const Vec3 q = d.cross(v);
    const double det = u.dot(q);
    if (det == 0.0) {
        return kMiss;
    }
    const Vec3 s = p - a;
    // In barycentric coordinates: a ray through an edge hits both neighbours rather than neither.
    constexpr double eps = 1e-12;
    const double beta = s.dot(q) / det;
    const Vec3 r = s.cross(u);
    const double gamma = d.dot(r) / det;
    if (!(beta >= -eps && gamma >= -eps && beta + gamma <= 1.0 + eps)) {
        return kMiss;
    }
    const double distance = v.dot(r) / det;
    return distance > 0.0 ? distance : kMiss;
}

bool isInside(const SurfaceIndex& surface, const Vec3& p)
{
    if (surface.triangleCount() == 0 || !p.allFinite() || !surface.bounds().contains(p)) {
        return false;
    }
    // Not along an axis or a diagonal, because anatomical models are often cut along these.
    static const std::array<Vec3, 3> kRays{Vec3(0.31, 0.53, 0.79).normalized(), Vec3(-0.67, 0.23, -0.71).normalized(),
                                           Vec3(0.19, -0.89, 0.43).normalized()};
    std::vector<double> walls;
    const bool first = hasOddCrossings(surface, p, kRays[0], walls);
    const bool second = hasOddCrossings(surface, p, kRays[1], walls);
    return first == second ? first : hasOddCrossings(surface, p, kRays[2], walls);
}

} // namespace palpate::geometry
