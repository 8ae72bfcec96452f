// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/haptics/internal/SurfaceWalk.h"

#include "palpate/haptics/internal/ConstrainedPoint.h"

#include <algorithm>
#include <array>

namespace palpate::haptics::internal {

namespace {

constexpr std::uint32_t kMostFacets = 64;
constexpr std::uint32_t kStepPrice = 12; // of going over to the next facet, in units of TickWork
constexpr double kFar = 16.0;            // facet sizes
constexpr double kSharpest = 0.5;        // cosine of the angle between two facets' normals
constexpr double kLifted = 0.5;          // skins above the next facet from which on it is walked on
constexpr double kBesideEdge = 8.0;      // skins beyond an edge that still are at it

/// Where the way to a place in a facet's plane leaves the facet.
struct Exit
{
    int edge = -1;            ///< 0 … 2: from corner a, b, c to the next; -1: it does not leave
    double share = 1.0;       ///< of the way
    bool isWellInside = true; ///< the place itself, by at least the margin
};

/// @param from,to    of the way [mm]
/// @param margin_mm  from the edges that is well inside
Exit exitFrom(const Facet& facet, const Vec3& from, const Vec3& to, double margin_mm) noexcept
{
    // Seen along the axis that shows most of the facet; the margin shrinks there with it.
    int axis = 0;
    double shown = std::abs(facet.n[0]);
    for (int i = 1; i < 3; ++i) {
        if (std::abs(facet.n[i]) > shown) {
            axis = i;
            shown = std::abs(facet.n[i]);
        }
    }
    const double turned = facet.n[axis] > 0.0 ? 1.0 : -1.0;
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    Exit exit;
    const std::array<const Vec3*, 4> corner{&facet.a, &facet.b, &facet.c, &facet.a};
    for (std::size_t e = 0; e < 3; ++e) {
        const Vec3 &p = *corner[e], &q = *corner[e + 1];
        const double u = turned * (q[j] - p[j]), v = turned * (q[k] - p[k]);
        const double end = u * (to[k] - p[k]) - v * (to[j] - p[j]); // to the left of the edge, times its length
        if (end > margin_mm * (std::abs(u) + std::abs(v))) {
            continue;
        }
        exit.isWellInside = false;
        if (end > 0.0) {
            continue;
        }
        const double begin = std::max(0.0, u * (from[k] - p[k]) - v * (from[j] - p[j]));
        const double share = begin > 0.0 ? begin / (begin - end) : 0.0;
        if (exit.edge < 0 || share < exit.share) {
            exit.edge = static_cast<int>(e);
            exit.share = share;
        }
    }
    return exit;
}

/// @return true when a god-object stands on a facet as one does that has walked there.
bool isOn(const Facet& facet, int side, const Vec3& g) noexcept
{
    return side * facet.n.dot(g - facet.a) > 0.6 * facet.skin_mm &&
           footOn(facet, side, g, geometry::SurfaceIndex::kClearHeight * facet.skin_mm, facet.skin_mm, 0.0) !=
               Foot::Away;
}

/// Where the surface falls away beyond an edge, the foot on the facet before it can leave that facet too early by its
/// height above it: goes on until the god-object is half a skin above the next facet's plane. From there the way along
/// that one passes the plane of the one before half a skin or more beyond their edge, as far as they turn by 60
/// degrees.
/// @param share  of the way from → target at which it leaves the facet before
/// @return false when that place is not at the edge
bool liftOver(const Facet& next, int side, const Vec3& from, const Vec3& target, double share, Vec3& to) noexcept
{
    const double least = kLifted * next.skin_mm;
    if (side * next.n.dot(to - next.a) >= least) {
        return true;
    }
    const double begin = side * next.n.dot(from - next.a), end = side * next.n.dot(target - next.a);
    const double lifted = (least - begin) / (end - begin);
    if (!(end > begin) || lifted > 1.0 || (lifted - share) * (target - from).norm() > kBesideEdge * next.skin_mm) {
        return false;
    }
    to = from + lifted * (target - from);
    return side * next.n.dot(to - next.a) > 0.0;
}

/// @return true when `p` is at least `least_mm` away from each corner.
bool isOffCorners(const Facet& facet, const Vec3& p, double least_mm) noexcept
{
    const double least2 = least_mm * least_mm;
    return (p - facet.a).squaredNorm() > least2 && (p - facet.b).squaredNorm() > least2 &&
           (p - facet.c).squaredNorm() > least2;
}

/// Where two facets with a common edge hold a god-object.
struct Crease
{
    Vec3 target;          ///< constrained point of the planes that hold [mm]
    int held = 0;         ///< how many of the two hold
    int first = 0;        ///< number of the first that does
    bool isWithin = true; ///< the target is between the ends of the edge, by at least the margin
};

/// @param edge  the common one's number in `facet`
Crease creaseAt(const Facet& facet, int edge, const Facet& beyond, int side, const Vec3& g, const Vec3& hip,
                double margin_mm) noexcept
{
    const Vec3 n = side * facet.n, m = side * beyond.n;
    const std::array planes{HalfSpace{n, facet.skin_mm - n.dot(g - facet.a)},
                            HalfSpace{m, beyond.skin_mm - m.dot(g - beyond.a)}};
    const Vec3 wanted = hip - g;
    const ConstrainedPoint point = constrainedPoint(wanted, planes, allowance(facet.skin_mm, wanted));
    const std::array<const Vec3*, 5> corner{&facet.a, &facet.b, &facet.c, &facet.a, &facet.b};
    const auto e = static_cast<std::size_t>(edge);
    const Vec3 &begin = *corner[e], &end = *corner[e + 1], &opposite = *corner[e + 2];
    Crease crease;
    crease.target = g + point.u;
    crease.held = m.dot(opposite - beyond.a) > 0.0 ? point.count : 0; // only where they rise towards each other
    crease.first = point.active[0];
    const Vec3 along = (end - begin).normalized();
    crease.isWithin = along.dot(crease.target - begin) > margin_mm && along.dot(end - crease.target) > margin_mm;
    return crease;
}

} // namespace

SurfaceWalk walk(const HapticScene& scene, const HapticLayer& layer, Neighbourhood& near, const Vec3& hip,
                 std::uint32_t most, int side, bool isWellInside, const Facet* second, Vec3& g, Facet& facet) noexcept
{
    SurfaceWalk result;
    const geometry::SurfaceIndex& surface = *scene.structures()[facet.structure].surface;
    std::array<Vec3, Neighbourhood::kMostPoints> path;            // moves that are still to be asked for
    std::array<FacetNumber, Neighbourhood::kMostPoints + 1> over; // of each point and, first, of that before them
    path[0] = g;
    over[0] = over[1] = {facet.structure, facet.triangle};
    std::size_t points = 1, crossed = 0;
    std::array<Facet, 2> met; // by turns
    const Facet* here = &facet;
    int entered = -1;
    const double margin_mm = kTouched * facet.skin_mm;
    const double offCorners_mm = geometry::SurfaceIndex::kClearOfCorners * facet.skin_mm;
    const auto isClearAt = [&](const Facet& f, const Vec3& p) {
        return surface.isClear(f.triangle) && isOffCorners(f, p, offCorners_mm) &&
               near.isAlone(scene, layer, f.structure, p);
    };
    result.isClear = (isWellInside || isOn(facet, side, g)) && isClearAt(facet, g);
    if (second != nullptr) {
        result.isClear = result.isClear && isOn(*second, side, g) && isClearAt(*second, g);
        result.isInCrease = true;
        result.beyond = *second;
    }
    const auto stand = [&] {
        if (here != &facet) {
            facet = *here;
        }
    };
    const auto isPathFree = [&] {
        // On one facet and over the edge to the next, neither can be in the way: a move begins and ends a skin above
        // the one it follows, and where their angle is at most 60 degrees it passes the other's plane half a skin or
        // more beyond their edge.
        const std::size_t moves = near.freeMoves(scene, layer, std::span<const Vec3>(path).first(points),
                                                 std::span<const FacetNumber>(over).first(crossed + 2));
        const bool isFree = moves + 1 == points;
        g = path[moves];
        result.moves += static_cast<std::uint32_t>(moves);
        if (!isFree) {
            facet = Facet::of(surface, facet.structure, over[moves + 1].triangle);
        } else {
            stand();
        }
        here = &facet;
        path[0] = g;
        over[0] = over[std::min(moves, crossed)];
        over[1] = {facet.structure, facet.triangle};
        points = 1;
        crossed = 0;
        return isFree;
    };
    // The last move: @return true when it was made.
    const auto hasArrivedAt = [&](const Vec3& target) {
        if (result.isClear) {
            g = target;
            ++result.moves;
            stand();
            return true;
        }
        path[points++] = target;
        return isPathFree();
    };
    if (second != nullptr) {
        int edge = 0;
        while (edge < 3 &&
               surface.neighbour(facet.triangle, static_cast<std::uint32_t>(edge)).triangle != second->triangle) {
            ++edge;
        }
        if (edge == 3) {
            return result;
        }
        const Crease crease = creaseAt(facet, edge, *second, side, g, hip, margin_mm);
        if (crease.held == 0 || (crease.held == 2 && !crease.isWithin)) {
            return result;
        }
        if (crease.held == 2) {
            result.isClear = result.isClear && isClearAt(facet, crease.target) && isClearAt(*second, crease.target);
            result.hasArrived = hasArrivedAt(crease.target);
            return result;
        }
        if (crease.first == 1) {
            facet = *second;
            over[0] = over[1] = {facet.structure, facet.triangle};
        }
        result.isInCrease = false;
    }
    for (std::uint32_t i = 0; i < std::min(most, kMostFacets); ++i) {
        near.spend(kStepPrice);
        const Vec3 outwards = side * here->n;
        const double rise = here->skin_mm - outwards.dot(hip - here->a);
        if (rise <= 0.0) {
            break; // let go
        }
        const Vec3 target = hip + rise * outwards;
        const Vec3& from = path[points - 1];
        if ((target - from).squaredNorm() > kFar * kFar * layer.facetSize_mm * layer.facetSize_mm) {
            break; // straight through the air is shorter
        }
        const Exit exit = exitFrom(*here, from, target, margin_mm);
        const bool isLast = exit.edge < 0;
        if (isLast && !exit.isWellInside) {
            break; // too near an edge to tell
        }
        if (!isLast && exit.edge == entered) {
            // Neither of two facets lets it go over to the other.
            const std::uint32_t other = surface.neighbour(here->triangle, static_cast<std::uint32_t>(entered)).triangle;
            const Facet beyond = Facet::of(surface, facet.structure, other);
            const Crease crease = creaseAt(*here, entered, beyond, side, from, hip, margin_mm);
            if (crease.held != 2) {
                break;
            }
            result.beyond = beyond;
            if (!crease.isWithin) {
                if (result.isClear) {
                    stand();
                }
                result.isInCrease = result.isClear || isPathFree();
                return result;
            }
            result.isClear = result.isClear && isClearAt(*here, crease.target) && isClearAt(beyond, crease.target);
            if (result.isClear || near.holds(crease.target) || isPathFree()) {
                result.isInCrease = result.hasArrived = hasArrivedAt(crease.target);
            }
            return result;
        }
        Vec3 to = isLast ? target : Vec3(from + exit.share * (target - from));
        result.isClear = result.isClear && isClearAt(*here, to);
        // What is gathered next may no longer hold the way up to here.
        if (!result.isClear && !near.holds(to) && !isPathFree()) {
            return result;
        }
        if (isLast) {
            result.hasArrived = hasArrivedAt(target);
            return result;
        }
        const geometry::SurfaceIndex::Neighbour neighbour =
            surface.neighbour(here->triangle, static_cast<std::uint32_t>(exit.edge));
        if (!result.isClear) {
            near.reach(scene, layer, path[points - 1], to, target);
        }
        if (neighbour.triangle == geometry::SurfaceIndex::kNoNeighbour) {
            break;
        }
        Facet& next = met[i % 2];
        next = Facet::of(surface, facet.structure, neighbour.triangle);
        entered = static_cast<int>(neighbour.edge);
        if (here->n.dot(next.n) < kSharpest) {
            break;
        }
        // Where the surface rises, the next facet is met before the edge.
        const double end = side * next.n.dot(target - next.a) - next.skin_mm;
        if (end < 0.0) {
            const double begin = side * next.n.dot(path[points - 1] - next.a) - next.skin_mm;
            const double share = begin > 0.0 ? begin / (begin - end) : 0.0;
            if (share < exit.share) {
                to = path[points - 1] + share * (target - path[points - 1]);
            }
        }
        if (!liftOver(next, side, path[points - 1], target, exit.share, to)) {
            break;
        }
        here = &next;
        if (result.isClear) {
            path[0] = g = to;
            over[0] = over[1];
            over[1] = {next.structure, next.triangle};
            ++result.moves;
            continue;
        }
        path[points] = to;
        over[++points] = {next.structure, next.triangle};
        ++crossed;
        if (points == path.size() && !isPathFree()) {
            return result;
        }
    }
    if (result.isClear) {
        stand();
    } else {
        (void)isPathFree();
    }
    return result;
}

} // namespace palpate::haptics::internal
