// SPDX-License-Identifier: BSD-3-Clause
#include "distance/TrianglePair.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace palpate::geometry {

namespace {

NearPair pairOf(const Vec3& p, const Vec3& q)
{
    return {p, q, (p - q).squaredNorm()};
}

/// Parameter of the point of a line that is closest to `p`, within the segment.
double alongSegment(const Vec3& from, const Vec3& direction, const Vec3& p)
{
    const double length2 = direction.squaredNorm();
    return length2 > 0.0 ? std::clamp((p - from).dot(direction) / length2, 0.0, 1.0) : 0.0;
}

/// Closest points of two segments. The parameter on the first line comes from the common normal: the difference of
/// products a e - b^2 in the textbook formula loses all digits for nearly parallel segments.
NearPair betweenSegments(const Vec3& p1, const Vec3& q1, const Vec3& p2, const Vec3& q2)
{
    const Vec3 d1 = q1 - p1, d2 = q2 - p2;
    const Vec3 n = d1.cross(d2);
    const double nn = n.squaredNorm(); // 0 for parallel segments: any point of the first will do
    double s = nn > 0.0 ? std::clamp((p2 - p1).cross(d2).dot(n) / nn, 0.0, 1.0) : 0.0;
    const double t = alongSegment(p2, d2, p1 + s * d1);
    s = alongSegment(p1, d1, p2 + t * d2);
    return pairOf(p1 + s * d1, p2 + t * d2);
}

NearPair toSegment(const Vec3& p, const Vec3& from, const Vec3& to)
{
    const Vec3 d = to - from;
    return pairOf(p, from + alongSegment(from, d, p) * d);
}

/// Projection of the point onto the triangle's plane if inside the triangle; otherwise an edge contains the closest
/// point.
std::optional<NearPair> above(const Vec3& p, const Corners& t)
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
std::optional<NearPair> through(const Vec3& p, const Vec3& q, const Corners& t)
{
    const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
    const double from = n.dot(p - t[0]), to = n.dot(q - t[0]);
    if (!(from * to < 0.0)) {
        return std::nullopt;
    }
    const auto at = above(p + from / (from - to) * (q - p), t);
    return at ? std::optional(NearPair{at->p, at->p, 0.0}) : std::nullopt;
}

NearPair swapped(const NearPair& pair)
{
    return {pair.q, pair.p, pair.distance2};
}

} // namespace

Corners cornersAt(const SurfaceIndex& surface, std::uint32_t i)
{
    const Triangle t = surface.triangle(i);
    return {surface.vertex(t[0]), surface.vertex(t[1]), surface.vertex(t[2])};
}

NearPair nearestOf(const Vec3& p, const Corners& triangle)
{
    if (const auto foot = above(p, triangle)) {
        return *foot;
    }
    NearPair nearest = toSegment(p, triangle[0], triangle[1]);
    for (std::size_t k = 1; k < 3; ++k) {
        const NearPair found = toSegment(p, triangle[k], triangle[(k + 1) % 3]);
        if (found.distance2 < nearest.distance2) {
            nearest = found;
        }
    }
    return nearest;
}

NearPair nearestOf(const Corners& a, const Corners& b)
{
    NearPair nearest = pairOf(a[0], b[0]);
    const auto take = [&nearest](const std::optional<NearPair>& found) {
        if (found && found->distance2 < nearest.distance2) {
            nearest = *found;
        }
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3;
        take(above(a[i], b));
        if (const auto found = above(b[i], a)) {
            take(swapped(*found));
        }
        take(through(a[i], a[next], b));
        take(through(b[i], b[next], a));
        for (std::size_t j = 0; j < 3; ++j) {
            take(betweenSegments(a[i], a[next], b[j], b[(j + 1) % 3]));
        }
    }
    return nearest;
}

} // namespace palpate::geometry
