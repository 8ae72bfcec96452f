// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/haptics/internal/Ball.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate::haptics::internal {

namespace {

constexpr double kNever = 2.0;

/// Smaller root of a t² + 2 b t + c with c > 0, kNever when there is none in front.
double firstRoot(double a, double b, double c) noexcept
{
    const double d = b * b - a * c;
    return b < 0.0 && d >= 0.0 ? c / (std::sqrt(d) - b) : kNever;
}

/// Share of the move x + t d at which its distance from the triangle falls to `r`; kNever when it stays farther or
/// would do so beyond `limit`. @pre the distance at x is greater than r
double entry(const Facet& facet, double side, const Vec3& x, const Vec3& d, double r, double limit) noexcept
{
    double first = kNever;
    const double sinking = -side * facet.n.dot(d);
    if (sinking > 0.0) {
        const double height = side * facet.n.dot(x - facet.a);
        const double t = (height - r) / sinking;
        if (t >= 0.0 && t <= limit) {
            const Vec3 p = x + t * d;
            const Vec3 pa = facet.a - p, pb = facet.b - p, pc = facet.c - p;
            if (facet.n.dot(pa.cross(pb)) >= 0.0 && facet.n.dot(pb.cross(pc)) >= 0.0 &&
                facet.n.dot(pc.cross(pa)) >= 0.0) {
                return t; // on the face: the other parts are entered later
            }
        }
    }
    const double d2 = d.squaredNorm(), r2 = r * r;
    const std::array<const Vec3*, 3> corner{&facet.a, &facet.b, &facet.c};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& v = *corner[i];
        const Vec3 w = x - v, e = *corner[(i + 1) % 3] - v;
        const double wd = w.dot(d), w2 = w.squaredNorm();
        if (w2 > r2) {
            first = std::min(first, firstRoot(d2, wd, w2 - r2));
        }
        // The cylinder around the edge: the same without the parts along it.
        const double e2 = e.squaredNorm();
        if (e2 > 0.0) {
            const double we = w.dot(e), de = d.dot(e);
            const double c = w2 - we * we / e2 - r2;
            if (c > 0.0) {
                const double t = firstRoot(d2 - de * de / e2, wd - we * de / e2, c);
                const double along = we + t * de;
                if (t < first && along >= 0.0 && along <= e2) {
                    first = t;
                }
            }
        }
    }
    return first <= limit ? first : kNever;
}

} // namespace

Nearest nearestOn(const Facet& facet, const Vec3& p) noexcept
{
    const Vec3 ab = facet.b - facet.a, ac = facet.c - facet.a, ap = p - facet.a;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0.0 && d2 <= 0.0) {
        return {facet.a, Vec3::Zero(), true, -1, 0};
    }
    const Vec3 bp = p - facet.b;
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0.0 && d4 <= d3) {
        return {facet.b, Vec3::Zero(), true, -1, 1};
    }
    const Vec3 cp = p - facet.c;
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0.0 && d5 <= d6) {
        return {facet.c, Vec3::Zero(), true, -1, 2};
    }
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
        return {facet.a + d1 / (d1 - d3) * ab, ab.normalized(), true, 0};
    }
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
        return {facet.a + d2 / (d2 - d6) * ac, ac.normalized(), true, 2};
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
        const Vec3 bc = facet.c - facet.b;
        return {facet.b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * bc, bc.normalized(), true, 1};
    }
    // By the plane rather than by the weights: exact for slivers, too.
    return {p - facet.n.dot(ap) * facet.n, Vec3::Zero(), false};
}

bool blocksBall(const Facet& facet, const Vec3& x, const Vec3& y, double radius_mm, double limit,
                BallCrossing& crossing) noexcept
{
    const double height = facet.n.dot(x - facet.a);
    const double onPlane = kOnPlane * facet.skin_mm;
    if (height < -onPlane && !facet.isTwoSided) {
        return false;
    }
    const double side = height < 0.0 && facet.isTwoSided ? -1.0 : 1.0;
    const Vec3 d = y - x;
    const Vec3 away = x - nearestOn(facet, x).q;
    const double closing = -away.dot(d);
    if (closing <= 0.0) {
        return false; // the distance from a convex set only grows from here
    }
    const double distance = away.norm();
    const double kept = radius_mm + facet.skin_mm;
    // What touches already comes first, whatever its entry.
    const bool isTouching = distance <= kept + 0.5 * facet.skin_mm;
    const double t = entry(facet, side, x, d, std::min(radius_mm, distance - onPlane), isTouching ? 1.0 : limit);
    if (t == kNever) {
        return false;
    }
    crossing.key = isTouching ? 0.0 : t;
    crossing.closing_mm = isTouching ? closing / distance : 0.0;
    crossing.stop = distance <= kept ? 0.0 : std::min(t, entry(facet, side, x, d, kept, 1.0));
    crossing.facet = facet;
    crossing.side = side > 0.0 ? 1 : -1;
    return true;
}

} // namespace palpate::haptics::internal
