// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/SurfaceGap.h"

#include "palpate/geometry/internal/BoxHierarchyVisit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate::geometry {

namespace {

using Triple = std::array<Vec3, 3>;

/// Pair of closest points, one on each surface.
struct NearPair
{
    Vec3 p, q;
    double distance2 = 0.0;
};

NearPair pairOf(const Vec3& p, const Vec3& q)
{
    return {p, q, (p - q).squaredNorm()};
}

Triple cornersAt(const SurfaceIndex& surface, std::uint32_t i)
{
    const Triangle t = surface.triangle(i);
    return {surface.vertex(t[0]), surface.vertex(t[1]), surface.vertex(t[2])};
}

core::Box boxAround(const Triple& corners)
{
    core::Box box;
    for (const Vec3& p : corners) {
        box.extend(p);
    }
    return box;
}

/// Closest points of two segments: Ericson, Real-Time Collision Detection (2005), 5.1.9.
NearPair betweenSegments(const Vec3& p1, const Vec3& q1, const Vec3& p2, const Vec3& q2)
{
    const Vec3 d1 = q1 - p1, d2 = q2 - p2, r = p1 - p2;
    const double a = d1.squaredNorm(), e = d2.squaredNorm(), f = d2.dot(r), c = d1.dot(r), b = d1.dot(d2);
    const double denominator = a * e - b * b; // 0 for parallel segments: any point of the first will do
    double s = denominator > 0.0 ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
    double t = e > 0.0 ? (b * s + f) / e : 0.0;
    if (t < 0.0 || t > 1.0) {
        t = std::clamp(t, 0.0, 1.0);
        s = a > 0.0 ? std::clamp((b * t - c) / a, 0.0, 1.0) : 0.0;
    }
    return pairOf(p1 + s * d1, p2 + t * d2);
}

/// Projection of the point onto the triangle's plane if inside the triangle; otherwise an edge contains the closest
/// point.
std::optional<NearPair> above(const Vec3& p, const Triple& t)
{
    const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
    const double nn = n.squaredNorm();
    if (!(nn > 0.0)) {
        return std::nullopt;
    }
    const Vec3 foot = p - (p - t[0]).dot(n) / nn * n;
    for (std::size_t k = 0; k < 3; ++k) {
        if ((t[(k + 1) % 3] - t[k]).cross(foot - t[k]).dot(n) < 0.0) {
            return std::nullopt;
        }
    }
    return pairOf(p, foot);
}

/// Intersection of the segment with the triangle.
std::optional<NearPair> through(const Vec3& p, const Vec3& q, const Triple& t)
{
    const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
    const double from = n.dot(p - t[0]), to = n.dot(q - t[0]);
    if (!(from * to < 0.0)) {
        return std::nullopt;
    }
    const auto at = above(p + from / (from - to) * (q - p), t);
    return at ? std::optional(NearPair{at->p, at->p, 0.0}) : std::nullopt;
}

/// Closest points of two triangles: between two edges, between a corner and a face, or at an intersection.
NearPair between(const Triple& a, const Triple& b)
{
    NearPair nearest = pairOf(a[0], b[0]);
    const auto take = [&nearest](const std::optional<NearPair>& found) {
        if (found && found->distance2 < nearest.distance2) {
            nearest = *found;
        }
    };
    for (std::size_t i = 0; i < 3; ++i) {
        take(above(a[i], b));
        take(above(b[i], a));
        take(through(a[i], a[(i + 1) % 3], b));
        take(through(b[i], b[(i + 1) % 3], a));
        for (std::size_t j = 0; j < 3; ++j) {
            take(betweenSegments(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]));
        }
    }
    return nearest;
}

core::Box grown(const core::Box& box, double by_mm)
{
    return {box.min() - Vec3::Constant(by_mm), box.max() + Vec3::Constant(by_mm)};
}

} // namespace

std::optional<SurfaceGap> nearestWithin(const SurfaceIndex& a, const SurfaceIndex& b, double within_mm,
                                        double touching_mm, std::size_t pairs)
{
    const bool isSwapped = a.triangleCount() > b.triangleCount();
    const SurfaceIndex &few = isSwapped ? b : a, &many = isSwapped ? a : b;
    const core::Box reach = grown(many.bounds(), within_mm);
    double nearest_mm = within_mm;
    std::size_t left = pairs;
    std::optional<SurfaceGap> found;
    for (std::uint32_t i = 0; i < few.triangleCount() && left > 0 && nearest_mm > touching_mm; ++i) {
        const Triple one = cornersAt(few, i);
        const core::Box box = boxAround(one);
        if (!box.intersects(reach)) {
            continue;
        }
        many.hierarchy().visitBox(grown(box, nearest_mm), [&](std::uint32_t first, std::uint32_t count) {
            for (std::uint32_t j = first; j < first + count && left > 0; ++j, --left) {
                const NearPair pair = between(one, cornersAt(many, j));
                if (const double distance_mm = std::sqrt(pair.distance2);
                    distance_mm < nearest_mm || (!found && distance_mm <= nearest_mm)) {
                    nearest_mm = distance_mm;
                    found = SurfaceGap{distance_mm, 0.5 * (pair.p + pair.q), false};
                }
            }
            return left > 0 && nearest_mm > touching_mm;
        });
    }
    if (found) {
        found->isBounded = left == 0;
    }
    return found;
}

} // namespace palpate::geometry
