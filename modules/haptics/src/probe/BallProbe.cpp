// SPDX-License-Identifier: BSD-3-Clause
#include "probe/BallProbe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace palpate::haptics::internal {

namespace {

constexpr double kNotReached = std::numeric_limits<double>::infinity();

/// Sine of the angle to an edge below which a move counts as parallel to the edge and enters at the ends, not at the
/// side.
constexpr double kAlong = 1e-15;

/// Intersects the line w + s u, relative to the centre of a sphere or of a cylinder's cross section, with the radius r.
/// The start counts as outside: if rounding puts it inside, it is treated as on the sphere. The distance of the line
/// from the centre is computed as a cross product, to avoid cancellation between large squares.
/// @param u  unit, or shorter by the component along the cylinder's axis
inline double firstRoot(const Vec3& w, const Vec3& u, double r) noexcept
{
    const double u2 = u.squaredNorm();
    const double nearest = -w.dot(u); // parameter of the closest approach, times u2
    if (nearest <= 0.0 || u2 <= kAlong * kAlong) {
        return kNotReached;
    }
    const double beside2 = w.cross(u).squaredNorm(); // squared distance of the line, times u2
    return beside2 <= r * r * u2 ? std::max(0.0, (nearest - std::sqrt(r * r * u2 - beside2)) / u2) : kNotReached;
}

/// Returns the distance along the move x + s u at which the distance from the triangle falls to `r` [mm]; kNotReached
/// if it stays larger, or if that happens beyond `limit`.
/// @param u  unit direction
/// @pre the distance at x exceeds r, and r > 0
double entry(const Facet& facet, double side, const Vec3& x, const Vec3& u, double r, double limit) noexcept
{
    double first = kNotReached;
    const double sinking = -side * facet.n.dot(u);
    if (sinking > 0.0) {
        const double height = side * facet.n.dot(x - facet.a);
        const double s = std::max(0.0, (height - r) / sinking);
        if (s <= limit) {
            const Vec3 p = x + s * u;
            const Vec3 pa = facet.a - p, pb = facet.b - p, pc = facet.c - p;
            if (facet.n.dot(pa.cross(pb)) >= 0.0 && facet.n.dot(pb.cross(pc)) >= 0.0 &&
                facet.n.dot(pc.cross(pa)) >= 0.0) {
                return s; // on the face: the other parts are entered later
            }
        }
    }
    const std::array<const Vec3*, 3> corner{&facet.a, &facet.b, &facet.c};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 w = x - *corner[i], e = *corner[(i + 1) % 3] - *corner[i];
        // Skip corners and edges that the move cannot reach before the first root found so far.
        double reach = r + std::min(first, limit);
        if (w.squaredNorm() <= reach * reach) {
            first = std::min(first, firstRoot(w, u, r));
            reach = r + std::min(first, limit);
        }
        const double e2 = e.squaredNorm();
        if (e2 > 0.0) {
            // The cylinder around the edge: same root, without the components along the edge.
            const double perEdge2 = 1.0 / e2, we = w.dot(e), ue = u.dot(e);
            const Vec3 across = w - (we * perEdge2) * e;
            if (across.squaredNorm() > reach * reach) {
                continue;
            }
            const double s = firstRoot(across, u - (ue * perEdge2) * e, r);
            const double along = we + s * ue;
            if (s < first && along >= 0.0 && along <= e2) {
                first = s;
            }
        }
    }
    return first <= limit ? first : kNotReached;
}

/// Inlined, so that unused members of the result cost nothing.
PALPATE_ALWAYS_INLINE Nearest nearest(const Facet& facet, const Vec3& p) noexcept
{
    const Vec3 ab = facet.b - facet.a, ac = facet.c - facet.a, ap = p - facet.a;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0.0 && d2 <= 0.0) {
        return {facet.a, ap, Vec3::Zero(), true, -1, 0};
    }
    const Vec3 bp = p - facet.b;
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0.0 && d4 <= d3) {
        return {facet.b, bp, Vec3::Zero(), true, -1, 1};
    }
    const Vec3 cp = p - facet.c;
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0.0 && d5 <= d6) {
        return {facet.c, cp, Vec3::Zero(), true, -1, 2};
    }
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
        const Vec3 along = d1 / (d1 - d3) * ab;
        return {facet.a + along, ap - along, ab.normalized(), true, 0};
    }
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
        const Vec3 along = d2 / (d2 - d6) * ac;
        return {facet.a + along, ap - along, ac.normalized(), true, 2};
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
        const Vec3 bc = facet.c - facet.b;
        const Vec3 along = (d4 - d3) / ((d4 - d3) + (d5 - d6)) * bc;
        return {facet.b + along, bp - along, bc.normalized(), true, 1};
    }
    // By the plane rather than by barycentric weights: accurate for slivers, too.
    const Vec3 away = facet.n.dot(ap) * facet.n;
    return {p - away, away, Vec3::Zero(), false};
}

} // namespace

Nearest nearestOn(const Facet& facet, const Vec3& p) noexcept
{
    return nearest(facet, p);
}

bool blocksBall(const Facet& facet, const Vec3& x, const Vec3& y, double radius_mm, double limit,
                BallCrossing& crossing, double leastClosing_mm) noexcept
{
    const double height = facet.n.dot(x - facet.a);
    const double onPlane = kPlaneTolerance * facet.skin_mm;
    if (height < -onPlane && !facet.isTwoSided) {
        return false;
    }
    const double side = height < 0.0 && facet.isTwoSided ? -1.0 : 1.0;
    const Vec3 d = y - x;
    const double length = d.norm();
    Vec3 away = nearest(facet, x).away;
    const double distance = away.norm();
    if (distance <= onPlane) {
        away = side * facet.n; // on the facet itself, the direction is the facet's normal
    }
    const double closing = -away.dot(d);
    if (closing <= 0.0) {
        return false; // the distance from a convex set only grows from here
    }
    const double kept = radius_mm + facet.skin_mm;
    crossing.facet = facet;
    crossing.side = side > 0.0 ? 1 : -1;
    if (distance <= onPlane) {
        crossing.key = crossing.stop = 0.0;
        crossing.closing_mm = closing;
        return true;
    }
    // Slightly above the limit, so that rounding removes none of several facets met at the same fraction.
    const double most = limit * length + onPlane;
    if (distance - radius_mm > most) {
        return false;
    }
    // A touching facet comes first regardless of its entry, and the move is not made at all.
    const bool isTouching = distance <= kept + onPlane;
    if (isTouching && closing / distance < leastClosing_mm) {
        return false;
    }
    // The distance is convex along the move and falls fastest at the start.
    if (distance - radius_mm - (isTouching ? length : most) * (closing / (distance * length)) > onPlane) {
        return false;
    }
    crossing.isTimed = true;
    const Vec3 u = d / length;
    const double s = entry(facet, side, x, u, std::min(radius_mm, distance - onPlane), isTouching ? length : most);
    if (s == kNotReached || (!isTouching && s / length > limit)) {
        return false;
    }
    crossing.key = isTouching ? 0.0 : s / length;
    crossing.closing_mm = isTouching ? closing / distance : 0.0;
    crossing.stop = isTouching ? 0.0 : std::min(s, entry(facet, side, x, u, kept, s)) / length;
    return true;
}

} // namespace palpate::haptics::internal
