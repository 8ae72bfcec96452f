// SPDX-License-Identifier: BSD-3-Clause
#include "probe/PointProbe.h"

#include <algorithm>
#include <array>
#include <utility>

namespace palpate::haptics::internal {

namespace {

// Square of 16 ulp: bounds the rounding of a volume relative to the lengths of its three vectors.
constexpr double kVolumeRounding2 = (16 * 2.220446049250313e-16) * (16 * 2.220446049250313e-16);

/// @param d  the move, against the normal; p, q corners seen from its start, in the triangle's order
/// @param around_mm  how far beside the edge it may still pass
bool isInsideEdge(const Vec3& d, double d2, const Vec3& p, const Vec3& q, double around_mm) noexcept
{
    const double volume = d.dot(p.cross(q));
    return volume <= 0.0 || volume * volume <= kVolumeRounding2 * d2 * p.squaredNorm() * q.squaredNorm() ||
           (around_mm > 0.0 && volume * volume <= around_mm * around_mm * d2 * (q - p).squaredNorm());
}

/// 16 ulp of the largest coordinate: as far as rounding may put a point beside an edge that it was meant to be on. [mm]
double roundingOf(const Facet& facet, const Vec3& x) noexcept
{
    const Vec3 most =
        x.cwiseAbs().cwiseMax(facet.a.cwiseAbs()).cwiseMax(facet.b.cwiseAbs()).cwiseMax(facet.c.cwiseAbs());
    return 16 * 2.220446049250313e-16 * most.maxCoeff();
}

/// @param start  distance in front of the facet at the move's start [mm]
/// @param along  share of the move at which it is met
/// @param d2     the move's length squared [mm²]
bool touches(const Facet& facet, double start, double along, double d2) noexcept
{
    const double beside = kTouched * facet.skin_mm;
    return start <= kTouching * facet.skin_mm && along * along * d2 <= beside * beside;
}

/// The part of a move, as shares of it, that some half-spaces have in common.
struct Part
{
    double begin = 0.0;
    double end = 1.0;

    /// Keeps what is at most `most`, of a value that goes from `from` at the move's start to `to` at its end.
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

/// @return the part of the move x → y that is in the facet's box, or at most `around_mm` beside it along any axis.
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

/// Keeps the part of the move x → y that is at most `around_mm` outside each of the facet's edges, seen along its
/// normal.
void clipToEdges(const Facet& facet, const Vec3& x, const Vec3& y, double around_mm, Part& part) noexcept
{
    const std::array<const Vec3*, 4> corner{&facet.a, &facet.b, &facet.c, &facet.a};
    for (std::size_t i = 0; i < 3 && !part.isEmpty(); ++i) {
        const Vec3 edge = *corner[i + 1] - *corner[i];
        const Vec3 outwards = edge.cross(facet.n);
        part.clip(outwards.dot(x - *corner[i]), outwards.dot(y - *corner[i]), around_mm * edge.norm());
    }
}

/// @return true when all of the move, seen along the normal, is beside the facet by more than counts as at its edge.
bool staysBeside(const Facet& facet, const Vec3& x, const Vec3& y) noexcept
{
    Part part;
    clipToEdges(facet, x, y, kBesideEdge * facet.skin_mm, part);
    return part.isEmpty();
}

/// @return the share of a move in a facet's plane that leads up to the facet: before it is at its edge, and before it
/// is behind the plane by more than counts as on it.
double shareBeside(const Facet& facet, const Vec3& x, const Vec3& y, double start, double end) noexcept
{
    const double around = kBesideEdge * facet.skin_mm;
    Part part = partInBox(facet, x, y, around);
    clipToEdges(facet, x, y, around, part);
    return std::max(0.0, std::min(part.begin, (start + kOnPlane * facet.skin_mm) / (start - end)));
}

/// A move seen from the side of a facet that it starts on.
struct Approach
{
    double side;  ///< +1: front, -1: back
    double start; ///< distance in front of the facet [mm]
    double end;
};

/// A plate around a facet is `half_mm` thick on both sides and as much wider than the triangle. A god-object that is
/// never in a plate never forgets on which side of the facet it is, and neighbours' plates overlap: rounding, far below
/// a plate, opens no gap between them.
bool entersPlate(const Facet& facet, const Vec3& x, const Vec3& y, const Approach& approach, double half_mm,
                 double limit, Crossing& crossing) noexcept
{
    const auto [side, start, end] = approach;
    const double half = half_mm, d2 = (y - x).squaredNorm();
    if (end > half) {
        return false;
    }
    Part inside = partInBox(facet, x, y, half); // there a sharp corner's plate ends
    const double beside = inside.begin;
    inside.clip(start, end, half);
    inside.clip(-start, -end, half);
    const double level = inside.begin;
    clipToEdges(facet, x, y, half, inside);
    // A god-object that was put down in a plate may leave it.
    if (inside.isEmpty() || (inside.begin <= 0.0 && (!facet.isTwoSided || end >= start))) {
        return false;
    }
    // A plate that is entered over its rim is entered from beside, where the facet's neighbour is or none: facets that
    // are touched come first.
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

/// How a move that ends behind a facet's plane goes past the facet.
enum class Passing : std::uint8_t
{
    Beside,
    Through,
    Later, ///< through it or beside it, but beyond the crossings that are of interest
};

/// Tests a move from a facet's front or plane to behind it. @param crossing  filled where it passes through
Passing passes(const Facet& facet, const Vec3& x, const Vec3& y, const Approach& approach, double limit,
               Crossing& crossing) noexcept
{
    const auto [side, start, end] = approach;
    const double onPlane = kOnPlane * facet.skin_mm;
    const Vec3 d = y - x;
    const double d2 = d.squaredNorm();
    const double along = start > 0.0 ? start / (start - end) : 0.0;
    const double slack = onPlane / (start - end); // rounding of that share
    if (along - 2.0 * slack > limit && start > kTouching * facet.skin_mm) {
        return Passing::Later; // its plate, too
    }
    const Vec3 xa = facet.a - x, xb = facet.b - x, xc = facet.c - x;
    // Where the facets of a hollow edge meet, a point that was put on it is behind both by rounding, and would pass
    // each beside the other.
    const double around = start <= onPlane ? std::min(onPlane, roundingOf(facet, x)) : 0.0;
    if (!isInsideEdge(d, d2, xa, xb, around) || !isInsideEdge(d, d2, xb, xc, around) ||
        !isInsideEdge(d, d2, xc, xa, around)) {
        return Passing::Beside;
    }
    const Part part = partInBox(facet, x, y, facet.skin_mm);
    if (part.isEmpty() || along + slack < part.begin || along - slack > part.end) {
        return Passing::Beside; // it is met beside the facet
    }
    if (start < onPlane && staysBeside(facet, x, y)) {
        return Passing::Beside; // nor does it come to the facet in its plane, where rounding tells where it is met
    }
    const double place = std::clamp(along, part.begin, part.end);
    const bool isTouched = touches(facet, start, place, d2);
    // In the facet's plane, rounding tells where it is met: that is where the move comes to its edge.
    const bool isBeside = !isTouched && start < onPlane;
    const double entered = std::clamp(along - slack, part.begin, part.end); // where it comes into the facet's plate
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

/// Around a facet without an inside there is a plate on both sides.
bool blocksTwoSided(const Facet& facet, const Vec3& x, const Vec3& y, double limit, Crossing& crossing) noexcept
{
    const double half = kPlate * facet.skin_mm;
    const double start = facet.n.dot(x - facet.a), end = facet.n.dot(y - facet.a);
    const double side = start < -kOnPlane * facet.skin_mm ? -1.0 : 1.0;
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
    const double onPlane = kOnPlane * facet.skin_mm;
    if (approach.start < -onPlane) {
        return false;
    }
    if (approach.end < 0.0 && approach.end < approach.start) {
        const Passing passing = passes(facet, x, y, approach, limit, crossing);
        if (passing != Passing::Beside) {
            return passing == Passing::Through;
        }
    }
    // To its plane, along it or past its edge: where another facet ends the move in the plate, rounding alone would
    // tell whether the next move passes at an edge.
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
        const double volume = side * d.dot(p->cross(*q)); // distance outside the edge, times the edge's length
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
