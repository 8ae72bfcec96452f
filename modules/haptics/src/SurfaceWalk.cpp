// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/haptics/internal/SurfaceWalk.h"

#include <algorithm>
#include <array>

namespace palpate::haptics::internal {

namespace {

constexpr int kMostFacets = 64;
constexpr double kSharpest = 0.5; // cosine of the angle between two facets' normals

/// Where the way to a place in a facet's plane leaves the facet.
struct Exit
{
    int edge = -1;
    double share = 1.0;
    bool isWellInside = true; ///< the place itself is, by the margin
};

/// @param entered  edge that the way came in by, -1: none
Exit exitFrom(const Facet& facet, const Vec3& from, const Vec3& to, double margin_mm) noexcept
{
    Exit exit;
    const std::array<const Vec3*, 3> corner{&facet.a, &facet.b, &facet.c};
    for (std::size_t e = 0; e < 3; ++e) {
        const Vec3& p = *corner[e];
        const Vec3 along = *corner[(e + 1) % 3] - p;
        const Vec3 inwards = facet.n.cross(along); // as long as the edge
        const double end = inwards.dot(to - p);
        if (end > 0.0 && end * end > margin_mm * margin_mm * along.squaredNorm()) {
            continue;
        }
        exit.isWellInside = false;
        if (end > 0.0) {
            continue;
        }
        const double begin = std::max(0.0, inwards.dot(from - p));
        const double share = begin > 0.0 ? begin / (begin - end) : 0.0;
        if (exit.edge < 0 || share < exit.share) {
            exit.edge = static_cast<int>(e);
            exit.share = share;
        }
    }
    return exit;
}

} // namespace

void walk(const HapticScene& scene, const HapticLayer& layer, Neighbourhood& near, const Vec3& hip, int side,
          double margin_mm, SurfaceWalk& at) noexcept
{
    std::array<Vec3, Neighbourhood::kMostPoints> path{at.g};
    std::array<std::uint32_t, Neighbourhood::kMostPoints> stands{at.facet.triangle};
    std::size_t points = 1;
    Facet facet = at.facet, next;
    int entered = -1;
    const auto isPathFree = [&] {
        const std::size_t moves = near.freeMoves(scene, layer, std::span<const Vec3>(path).first(points));
        const bool isFree = moves + 1 == points;
        at.g = path[moves];
        at.moves += static_cast<std::uint32_t>(moves);
        at.facet = isFree ? facet
                          : Facet::of(*scene.structures()[facet.structure].surface, facet.structure, stands[moves]);
        path[0] = at.g;
        stands[0] = at.facet.triangle;
        points = 1;
        return isFree;
    };
    for (int i = 0; i < kMostFacets; ++i) {
        const Vec3 outwards = side * facet.n;
        const double rise = facet.skin_mm - outwards.dot(hip - facet.a);
        if (rise <= 0.0) {
            break; // let go
        }
        const Vec3 target = hip + rise * outwards;
        const Vec3 from = path[points - 1];
        const Exit exit = exitFrom(facet, from, target, margin_mm);
        const bool isLast = exit.edge < 0;
        if (isLast ? !exit.isWellInside : exit.edge == entered) {
            break; // held by an edge, or too near one to tell
        }
        Vec3 to = isLast ? target : Vec3(from + exit.share * (target - from));
        // What is gathered next may no longer hold the way up to here.
        if (!near.holds(to) && !isPathFree()) {
            return;
        }
        if (isLast) {
            path[points++] = target;
            at.hasArrived = isPathFree();
            return;
        }
        if (!near.beyondEdge(scene, layer, from, to, target, facet, exit.edge, next, entered) ||
            facet.n.dot(next.n) < kSharpest) {
            break;
        }
        // Where the surface rises, the next facet is met before the edge.
        const double begin = side * next.n.dot(from - next.a) - next.skin_mm;
        const double end = side * next.n.dot(target - next.a) - next.skin_mm;
        if (end < 0.0) {
            const double share = begin > 0.0 ? begin / (begin - end) : 0.0;
            if (share < exit.share) {
                to = from + share * (target - from);
            }
        }
        facet = next;
        path[points] = to;
        stands[points++] = facet.triangle;
        if (points == path.size() && !isPathFree()) {
            return;
        }
    }
    (void)isPathFree();
}

} // namespace palpate::haptics::internal
