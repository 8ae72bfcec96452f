// SPDX-License-Identifier: BSD-3-Clause
#include "probe/PointProbe.h"

#include <algorithm>
#include <array>
#include <utility>

namespace palpate::haptics::internal {

namespace {

// Square of 16 ulp: bounds the rounding error of a triple product relative to the lengths of its three vectors.
constexpr double kVolumeRounding2 = (16 * 2.220446049250313e-16) * (16 * 2.220446049250313e-16);

/// @param d  the move, against the normal
/// @param d2  squared length of `d`
/// @param p,q  corners relative to the start of the move, in the triangle's order
/// @param around_mm  distance outside the edge at which the move still counts as inside
bool isInsideEdge(const Vec3& d, double d2, const Vec3& p, const Vec3& q, double around_mm) noexcept
{
    const double volume = d.dot(p.cross(q));
    return volume <= 0.0 || volume * volume <= kVolumeRounding2 * d2 * p.squaredNorm() * q.squaredNorm() ||
           (around_mm > 0.0 && volume * volume <= around_mm * around_mm * d2 * (q - p).squaredNorm());
}

/// 16 ulp of the largest coordinate [mm]: how far rounding may displace a point from an edge on which it was placed.
double roundingOf(const Facet& facet, const Vec3& x) noexcept
{
    const Vec3 most =
        x.cwiseAbs().cwiseMax(facet.a.cwiseAbs()).cwiseMax(facet.b.cwiseAbs()).cwiseMax(facet.c.cwiseAbs());
    return 16 * 2.220446049250313e-16 * most.maxCoeff();
}

/// Tests whether a facet is touched at the start of the move.
/// @param start  distance in front of the facet at the move's start [mm]
/// @param along  fraction of the move at which the facet is met
/// @param d2     squared length of the move [mm²]
bool touches(const Facet& facet, double start, double along, double d2) noexcept
{
    const double beside = kTouchRadius * facet.skin_mm;
    return start <= kTouching * facet.skin_mm && along * along * d2 <= beside * beside;
}

/// Interval of a move, in fractions of its length, inside several half-spaces.
struct Part
{
    double begin = 0.0;
    double end = 1.0;

    /// Clips to values of at most `most`, for a quantity that varies linearly from `from` at the start of the move to
    /// `to` at the end.
    void clip(double from, double to, double most) noexcept
    {
        if (from > most && to > most) {
            end = -1.0;
        } else if (from > most) {
            begin = std::max(begin, (from - most) / (from - to));
        } else if (to > most) {
            end = std::min(end, (most - from) / (to - from));
        }
    }
    [[nodiscard]] bool isEmpty() const noexcept { return begin > end; }
};

/// Returns the interval of the move x → y inside the facet's bounding box, enlarged by `around_mm` along each axis.
Part partInBox(const Facet& facet, const Vec3& x, const Vec3& y, double around_mm) noexcept
{
    Part part;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = facet.a[axis], b = facet.b[axis], c = facet.c[axis];
        part.clip(x[axis], y[axis], std::max({a, b, c}) + around_mm);
        part.clip(-x[axis], -y[axis], around_mm - std::min({a, b, c}));
    }
    return part;
}

/// Clips to the interval of the move x → y that is at most `around_mm` outside each of the facet's edges, as projected
/// along the normal.
void clipToEdges(const Facet& facet, const Vec3& x, const Vec3& y, double around_mm, Part& part) noexcept
{
    const std::array<const Vec3*, 4> corner{&facet.a, &facet.b, &facet.c, &facet.a};
    for (std::size_t i = 0; i < 3 && !part.isEmpty(); ++i) {
        const Vec3 edge = *corner[i + 1] - *corner[i];
        const Vec3 outwards = edge.cross(facet.n);
        part.clip(outwards.dot(x - *corner[i]), outwards.dot(y - *corner[i]), around_mm * edge.norm());
    }
}

/// Returns true if the whole move, projected along the normal, is farther outside the facet than the tolerance for
/// being at the edge.
bool staysBeside(const Facet& facet, const Vec3& x, const Vec3& y) noexcept
{
    Part part;
    clipToEdges(facet, x, y, kEdgeTolerance * facet.skin_mm, part);
    return part.isEmpty();
}

/// Returns the fraction of a move within a facet's plane that may be made: up to the edge of the facet, and until the
/// depth behind the plane exceeds the tolerance for being on the plane.
double shareBeside(const Facet& facet, const Vec3& x, const Vec3& y, double start, double end) noexcept
{
    const double around = kEdgeTolerance * facet.skin_mm;
    Part part = partInBox(facet, x, y, around);
    clipToEdges(facet, x, y, around, part);
    return std::max(0.0, std::min(part.begin, (start + kPlaneTolerance * facet.skin_mm) / (start - end)));
}

/// A move as seen from the side of a facet where it starts.
struct Approach
{
    double side;  ///< +1: front, -1: back
    double start; ///< distance in front of the facet [mm]
    double end;
};

/// Tests whether a move enters the plate around a facet. The plate extends `half_mm` from the facet on both sides and
/// beyond its edges. A god-object that never enters a plate cannot lose track of its side of the facet. Plates of
/// neighbours overlap, and rounding is far smaller than a plate, so that there are no gaps between them.
bool entersPlate(const Facet& facet, const Vec3& x, const Vec3& y, const Approach& approach, double half_mm,
                 double limit, Crossing& crossing) noexcept
{
    const auto [side, start, end] = approach;
    const double half = half_mm, d2 = (y - x).squaredNorm();
    if (end > half) {
        return false;
    }
    Part inside = partInBox(facet, x, y, half); // the bounding box truncates the plate at a sharp corner
    const double beside = inside.begin;
    inside.clip(start, end, half);
    inside.clip(-start, -end, half);
    const double level = inside.begin;
    clipToEdges(facet, x, y, half, inside);
    // A god-object that was placed inside a plate may leave.
    if (inside.isEmpty() || (inside.begin <= 0.0 && (!facet.isTwoSided || end >= start))) {
        return false;
    }
    // A plate entered through its rim is entered from the side, where the adjacent facet is, or no facet. Touched
    // facets take precedence.
    const bool isOverRim = inside.begin > level || (inside.begin > 0.0 && inside.begin == beside);
    const bool isTouched = !isOverRim && touches(facet, start, inside.begin, d2);
    const double key = isTouched ? 0.0 : inside.begin;
    if (key > limit) {
        return false;
    }
    crossing.key = key;
    crossing.depth = -end;
    const double stop = isOverRim ? inside.begin - half / std::sqrt(d2) : (start - facet.skin_mm) / (start - end);
    crossing.stop = isTouched ? 0.0 : std::max(0.0, stop);
    crossing.facet = facet;
    crossing.side = side > 0.0 ? 1 : -1;
    return true;
}

/// How a move that ends behind a facet's plane passes the facet.
enum class Passing : std::uint8_t
{
    Beside,
    Through,
    Later, ///< through or beside, but after the crossings of interest
};

/// Tests a move that starts on the front or on the plane of a facet and ends behind the plane.
/// @param crossing  set if the move passes through the facet
Passing passes(const Facet& facet, const Vec3& x, const Vec3& y, const Approach& approach, double limit,
               Crossing& crossing) noexcept
{
    const auto [side, start, end] = approach;
    const double onPlane = kPlaneTolerance * facet.skin_mm;
    const Vec3 d = y - x;
    const double d2 = d.squaredNorm();
    const double along = start > 0.0 ? start / (start - end) : 0.0;
    const double slack = onPlane / (start - end); // rounding error of `along`
    if (along - 2.0 * slack > limit && start > kTouching * facet.skin_mm) {
        return Passing::Later; // applies to the plate as well
    }
    const Vec3 xa = facet.a - x, xb = facet.b - x, xc = facet.c - x;
    // A point placed on a concave edge is, by rounding, behind both facets, and would pass each of them beside the
    // other without this tolerance.
    const double around = start <= onPlane ? std::min(onPlane, roundingOf(facet, x)) : 0.0;
    if (!isInsideEdge(d, d2, xa, xb, around) || !isInsideEdge(d, d2, xb, xc, around) ||
        !isInsideEdge(d, d2, xc, xa, around)) {
        return Passing::Beside;
    }
    const Part part = partInBox(facet, x, y, facet.skin_mm);
    if (part.isEmpty() || along + slack < part.begin || along - slack > part.end) {
        return Passing::Beside; // the plane is crossed beside the facet
    }
    if (start < onPlane && staysBeside(facet, x, y)) {
        return Passing::Beside; // The crossing of the plane is determined by rounding, and the move never comes to the
                                // facet within the plane.
    }
    const double place = std::clamp(along, part.begin, part.end);
    const bool isTouched = touches(facet, start, place, d2);
    // For a move within the facet's plane, the crossing is determined by rounding. Use the point at which the move
    // reaches the facet's edge.
    const bool isBeside = !isTouched && start < onPlane;
    const double entered = std::clamp(along - slack, part.begin, part.end); // where the move enters the facet's plate
    crossing.key = isTouched ? 0.0 : isBeside ? std::min(place, shareBeside(facet, x, y, start, end)) : entered;
    if (crossing.key > limit) {
        return Passing::Later;
    }
    crossing.depth = -end;
    crossing.stop =
        isBeside ? crossing.key : std::min(crossing.key, std::max(0.0, (start - facet.skin_mm) / (start - end)));
    crossing.facet = facet;
    crossing.side = 1;
    return Passing::Through;
}

/// A two-sided facet has a plate on both sides.
bool blocksTwoSided(const Facet& facet, const Vec3& x, const Vec3& y, double limit, Crossing& crossing) noexcept
{
    const double half = kPlate * facet.skin_mm;
    const double start = facet.n.dot(x - facet.a), end = facet.n.dot(y - facet.a);
    const double side = start < -kPlaneTolerance * facet.skin_mm ? -1.0 : 1.0;
    return side * end <= half && entersPlate(facet, x, y, {side, side * start, side * end}, half, limit, crossing);
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
    if (facet.isTwoSided) {
        return blocksTwoSided(facet, x, y, limit, crossing);
    }
    const Approach approach{1.0, facet.n.dot(x - facet.a), facet.n.dot(y - facet.a)};
    const double onPlane = kPlaneTolerance * facet.skin_mm;
    if (approach.start < -onPlane) {
        return false;
    }
    if (approach.end < 0.0 && approach.end < approach.start) {
        const Passing passing = passes(facet, x, y, approach, limit, crossing);
        if (passing != Passing::Beside) {
            return passing == Passing::Through;
        }
    }
    // The move ends at the plane, runs along the plane or passes the facet's edge. If another facet ended the move
    // inside the plate, rounding would decide whether the next move passes at the edge.
    return approach.end < onPlane && entersPlate(facet, x, y, approach, onPlane, limit, crossing);
}

Footing footingOn(const Facet& facet, int side, const Vec3& g, const Standing& standing) noexcept
{
    const auto [gap_mm, slack_mm, edge_mm] = standing;
    const Vec3 ga = facet.a - g, gb = facet.b - g, gc = facet.c - g;
    if (std::abs(facet.n.dot(ga)) > gap_mm) {
        return Footing::Away;
    }
    const Vec3 d = -side * facet.n;
    Footing footing = Footing::Inside;
    for (const auto& [p, q] : {std::pair(&ga, &gb), std::pair(&gb, &gc), std::pair(&gc, &ga)}) {
        const double volume = side * d.dot(p->cross(*q)); // distance outside the edge, times the length of the edge
        const double volume2 = volume * volume, edge2 = (*q - *p).squaredNorm();
        if (volume > 0.0 && volume2 > slack_mm * slack_mm * edge2 &&
            volume2 > kVolumeRounding2 * p->squaredNorm() * q->squaredNorm()) {
            return Footing::Away;
        }
        if (volume > 0.0 || volume2 < edge_mm * edge_mm * edge2) {
            footing = Footing::AtEdge;
        }
    }
    return footing;
}

} // namespace palpate::haptics::internal
