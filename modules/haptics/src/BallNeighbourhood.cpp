// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/haptics/internal/BallNeighbourhood.h"

#include "palpate/haptics/internal/AsFloats.h"
#include "palpate/haptics/internal/InsideShare.h"

#include <algorithm>

namespace palpate::haptics::internal {

namespace {

constexpr int kMostPieces = 8; // of a long move, before the whole hierarchy is searched
constexpr double kShort = 0.5; // radii: a move that is told off as a whole, from its middle

GatheringPlan planFor(const HapticScene& scene, const HapticLayer& layer) noexcept
{
    const double radius = scene.fingertip_mm();
    return {.few = 100,
            .many = 220,
            .narrowest_mm = 0.25 * layer.facetSize_mm,
            .widest_mm = std::max(16.0 * layer.facetSize_mm, 2.0 * radius),
            .around_mm = radius + 4.0 * layer.skin_mm};
}

bool isBefore(const BallCrossing& a, const BallCrossing& b) noexcept
{
    if (a.key != b.key) {
        return a.key < b.key;
    }
    if (a.stop != b.stop) {
        return a.stop < b.stop;
    }
    if (a.closing_mm != b.closing_mm) {
        return a.closing_mm > b.closing_mm; // of many that touch, what stands against the move most
    }
    return a.facet.structure != b.facet.structure ? a.facet.structure < b.facet.structure
                                                  : a.facet.triangle < b.facet.triangle;
}

} // namespace

/// Keeps the first crossing of those offered. The order of the offers does not matter.
struct BallNeighbourhood::First
{
    const Vec3& x;
    const Vec3& y;
    double radius_mm;
    BallCrossing& best;
    double limit;
    bool found = false;

    void offer(const geometry::SurfaceIndex& surface, std::uint32_t structure, std::uint32_t triangle) noexcept
    {
        BallCrossing crossing;
        if (blocksBall(Facet::of(surface, structure, triangle), x, y, radius_mm, limit, crossing) &&
            (!found || isBefore(crossing, best))) {
            best = crossing;
            limit = crossing.key;
            found = true;
        }
    }
};

void BallNeighbourhood::endTick(const HapticScene& scene, const HapticLayer& layer, const Vec3& g) noexcept
{
    m_cache.follow(g);
    m_cache.prepare(scene, layer, planFor(scene, layer), false);
}

/// A short move is told off from its middle, a long one from its start: it is expected to end early.
template<class Facets>
void BallNeighbourhood::offerFrom(const HapticScene& scene, const Facets& facets, First& first) noexcept
{
    const Vec3 move = first.y - first.x;
    const double length = move.norm();
    const bool isShort = length < kShort * first.radius_mm;
    const Vec3 half = isShort ? Vec3(0.5 * move) : Vec3(Vec3::Zero());
    float at[3], along[3];
    const float coordinate = std::max(facets.reach_mm(), asFloats(first.x + half, facets.origin(), at));
    (void)asFloats(half, Vec3::Zero(), along);
    alignas(32) float distance_mm[kMostTriangles];
    distances(facets.groups(), facets.count(), at, along, distance_mm);
    const double touching = first.radius_mm + leastDistanceRounding(coordinate, half.norm(), first.radius_mm);
    const auto offer = [&](int i) {
        first.offer(*scene.structures()[facets.structure(i)].surface, facets.structure(i), facets.triangle(i));
    };
    if (isShort) {
        forEachBetween(distance_mm, facets.count(), kAnyDistance, touching, offer);
        return;
    }
    // The nearer first: what is met early spares the rest.
    double offered = kAnyDistance;
    for (const double share : {0.01, 0.05, 0.25, 1.0}) {
        const double upTo = touching + length * std::min(share, first.limit);
        forEachBetween(distance_mm, facets.count(), offered, upTo, offer);
        offered = upTo;
        if (first.limit <= share) {
            return;
        }
    }
}

bool BallNeighbourhood::sweep(const HapticScene& scene, const HapticLayer& layer, const Vec3& x, const Vec3& y,
                              BallCrossing& first) noexcept
{
    const double radius = scene.fingertip_mm();
    if ((y - x).norm() < kShort * radius) {
        const auto take = [&] {
            return m_close.take(m_cache.held(), x, y, m_cache.motion(), radius, layer.facetSize_mm);
        };
        if ((m_close.covers(x) && m_close.covers(y)) || take() || (m_cache.takePrepared(scene, x, y) && take())) {
            First nearest{x, y, radius, first, 1.0};
            offerFrom(scene, m_close, nearest);
            return nearest.found;
        }
    }
    const GatheringPlan plan = planFor(scene, layer);
    double done = 0.0; // share of the move that is known to be free
    // Piece by piece: what is gathered for the last of them serves the moves that follow.
    for (int piece = 0; piece <= kMostPieces; ++piece) {
        const Vec3 p = x + done * (y - x);
        if ((piece > 0 || !m_cache.holds(p)) && !m_cache.takePrepared(scene, p, p) &&
            !m_cache.gather(scene, layer, plan, p, y)) {
            // Half the margin each time.
            for (int again = 0; again < 4 && !m_cache.gather(scene, layer, plan, p, p); ++again) {
            }
        }
        if (!m_cache.holds(p)) {
            break;
        }
        const double upTo = done + (1.0 - done) * insideShare(m_cache.held().region(), p, y);
        First nearest{x, y, radius, first, upTo};
        offerFrom(scene, m_cache.held(), nearest);
        if (nearest.found || upTo >= 1.0) {
            return nearest.found;
        }
        done = upTo;
    }
    First nearest{x, y, radius, first, 1.0};
    const double around = radius + 4.0 * layer.skin_mm;
    layer.hierarchy.visitSegment(
        x, y,
        [&](std::uint32_t firstStructure, std::uint32_t structureCount) {
            for (std::uint32_t s = firstStructure; s < firstStructure + structureCount; ++s) {
                const std::uint32_t number = layer.structures[s];
                const geometry::SurfaceIndex& surface = *scene.structures()[number].surface;
                surface.hierarchy().visitSegment(
                    x, y,
                    [&](std::uint32_t i, std::uint32_t n) {
                        for (const std::uint32_t end = i + n; i < end; ++i) {
                            nearest.offer(surface, number, i);
                        }
                        return nearest.limit;
                    },
                    around);
            }
            return nearest.limit;
        },
        around);
    return nearest.found;
}

} // namespace palpate::haptics::internal
