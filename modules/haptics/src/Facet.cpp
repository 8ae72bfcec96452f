// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/haptics/internal/Facet.h"

#include <algorithm>
#include <utility>

namespace palpate::haptics::internal {

namespace {

// Square of 16 ulp: bounds the rounding of a volume relative to the lengths of its three vectors.
constexpr double kVolumeRounding2 = (16 * 2.220446049250313e-16) * (16 * 2.220446049250313e-16);

/// @param d  the move; p, q corners seen from its start, in the triangle's order; `side` +1 for a move against the
/// normal
bool isInsideEdge(const Vec3& d, double d2, const Vec3& p, const Vec3& q, double side) noexcept
{
    const double volume = side * d.dot(p.cross(q));
    return volume <= 0.0 || volume * volume <= kVolumeRounding2 * d2 * p.squaredNorm() * q.squaredNorm();
}

} // namespace

Facet Facet::of(const geometry::SurfaceIndex& surface, std::uint32_t structure, std::uint32_t triangle) noexcept
{
    const geometry::Triangle t = surface.triangle(triangle);
    Facet facet;
    facet.a = surface.vertex(t[0]);
    facet.b = surface.vertex(t[1]);
    facet.c = surface.vertex(t[2]);
    facet.n = (facet.b - facet.a).cross(facet.c - facet.a).normalized();
    facet.skin_mm = surface.skin_mm();
    facet.structure = structure;
    facet.triangle = triangle;
    facet.isTwoSided = surface.isTwoSided(triangle);
    return facet;
}

bool blocks(const Facet& facet, const Vec3& x, const Vec3& y, double limit, Crossing& crossing) noexcept
{
    double start = facet.n.dot(x - facet.a);
    double end = facet.n.dot(y - facet.a);
    const double onPlane = kOnPlane * facet.skin_mm;
    double side = 1.0;
    if (start < -onPlane) {
        if (!facet.isTwoSided) {
            return false;
        }
        side = -1.0;
        start = -start;
        end = -end;
    }
    // Where there is no inside, the side is the one the god-object came from: it never comes so near that rounding
    // could forget it.
    if (end >= (facet.isTwoSided ? 0.5 * facet.skin_mm : 0.0) || end >= start) {
        return false;
    }
    const double along = start > 0.0 ? start / (start - end) : 0.0;
    const double key = start <= 1.5 * facet.skin_mm ? 0.0 : along;
    if (key > limit) {
        return false;
    }
    const Vec3 d = y - x, xa = facet.a - x, xb = facet.b - x, xc = facet.c - x;
    const double d2 = d.squaredNorm();
    if (!isInsideEdge(d, d2, xa, xb, side) || !isInsideEdge(d, d2, xb, xc, side) ||
        !isInsideEdge(d, d2, xc, xa, side)) {
        return false;
    }
    crossing.key = key;
    crossing.depth = -end;
    crossing.stop = std::max(0.0, (start - facet.skin_mm) / (start - end));
    crossing.facet = facet;
    crossing.side = side > 0.0 ? 1 : -1;
    return true;
}

Foot footOn(const Facet& facet, int side, const Vec3& g, double gap_mm, double slack_mm, double edge_mm) noexcept
{
    const Vec3 ga = facet.a - g, gb = facet.b - g, gc = facet.c - g;
    if (std::abs(facet.n.dot(ga)) > gap_mm) {
        return Foot::Away;
    }
    const Vec3 d = -side * facet.n;
    Foot foot = Foot::Inside;
    for (const auto& [p, q] : {std::pair(&ga, &gb), std::pair(&gb, &gc), std::pair(&gc, &ga)}) {
        const double volume = side * d.dot(p->cross(*q)); // distance outside the edge, times the edge's length
        const double volume2 = volume * volume, edge2 = (*q - *p).squaredNorm();
        if (volume > 0.0 && volume2 > slack_mm * slack_mm * edge2 &&
            volume2 > kVolumeRounding2 * p->squaredNorm() * q->squaredNorm()) {
            return Foot::Away;
        }
        if (volume > 0.0 || volume2 < edge_mm * edge_mm * edge2) {
            foot = Foot::AtEdge;
        }
    }
    return foot;
}

} // namespace palpate::haptics::internal
