// SPDX-License-Identifier: BSD-3-Clause
#include "nearby/NearPoint.h"

#include "nearby/AsFloats.h"
#include "nearby/InsideShare.h"

#include <palpate/geometry/internal/BoxHierarchyVisit.h>

#include <algorithm>
#include <bit>

namespace palpate::haptics::internal {

namespace {

constexpr double kFarMove = 8.0; // facet sizes; gathering along longer moves does not pay

// In units of TickWork.
constexpr std::uint32_t kExactTest = 5;                  // price of an exact test, in addition to 1 per visited facet
constexpr std::uint32_t kSpared = 128 + 64 * kExactTest; // work of a traversal included in the price of a sweep

GatheringPlan planFor(const HapticLayer& layer) noexcept
{
    return {.few = 16,
            .many = 48,
            .narrowest_mm = 0.2 * layer.facetSize_mm,
            .widest_mm = 16.0 * layer.facetSize_mm,
            .around_mm = kMaxQueryRadius * layer.skin_mm};
}

bool isAmong(std::span<const FacetNumber> facets, std::uint32_t structure, std::uint32_t triangle) noexcept
{
    return std::any_of(facets.begin(), facets.end(), [&](const FacetNumber& facet) {
        return facet.triangle == triangle && facet.structure == structure;
    });
}

/// Returns true if a move ends in front of a one-sided plane, by more than the contact tolerance.
/// @param n    normal, of any length
/// @param end  distance in front of the plane at the end of the move, times that length
bool endsInFront(const Vec3& n, double end, double skin_mm) noexcept
{
    return end > 0.0 && end * end >= kPlaneTolerance * kPlaneTolerance * skin_mm * skin_mm * n.squaredNorm();
}

/// Returns the facets below a path that cannot block its move i.
std::span<const FacetNumber> aroundMove(std::span<const FacetNumber> walked, std::size_t i) noexcept
{
    const std::span<const FacetNumber> left = walked.subspan(std::min(i, walked.size()));
    return left.first(std::min<std::size_t>(3, left.size()));
}

bool isBefore(const Crossing& a, const Crossing& b) noexcept
{
    if (a.key != b.key) {
        return a.key < b.key;
    }
    if (a.depth != b.depth) {
        return a.depth > b.depth;
    }
    return a.facet.structure != b.facet.structure ? a.facet.structure < b.facet.structure
                                                  : a.facet.triangle < b.facet.triangle;
}

} // namespace

/// Keeps the first of the crossings offered. The result does not depend on the order of the offers.
struct NearPoint::First
{
    const Vec3& x;
    const Vec3& y;
    double skin_mm; ///< of the layer
    Crossing& best;
    std::span<const FacetNumber> walked;
    double limit;
    bool found = false;
    std::uint32_t cost = 0; ///< cost of all offers

    void offer(const geometry::SurfaceIndex& surface, std::uint32_t structure, std::uint32_t triangle) noexcept
    {
        ++cost;
        // Most offers are rejected here.
        if (!surface.isTwoSided(triangle)) {
            const geometry::Triangle t = surface.triangle(triangle);
            const Vec3& a = surface.vertex(t[0]);
            const Vec3 n = (surface.vertex(t[1]) - a).cross(surface.vertex(t[2]) - a);
            if (endsInFront(n, n.dot(y - a), skin_mm)) {
                return;
            }
        }
        if (isAmong(walked, structure, triangle)) {
            return;
        }
        cost += kExactTest;
        const Facet facet = Facet::of(surface, structure, triangle);
        Crossing crossing;
        if (blocks(facet, x, y, limit, crossing) && (!found || isBefore(crossing, best))) {
            best = crossing;
            limit = crossing.key;
            found = true;
        }
    }
};

void NearPoint::endTick(const HapticLayer& layer, const Vec3& g) noexcept
{
    m_cache.follow(g);
    m_cache.prepare(layer, planFor(layer), false);
}

void NearPoint::endClearTick(const HapticLayer& layer, const Vec3& g, bool isClearAround) noexcept
{
    m_cache.follow(g);
    if (!isClearAround) {
        m_cache.prepare(layer, planFor(layer), true);
    }
}

void NearPoint::endFreeTick(const HapticLayer& layer, const Vec3& g) noexcept
{
    m_cache.follow(g);
    if (!m_empty.contains(m_cache.soon())) {
        m_cache.prepare(layer, planFor(layer), false);
    }
    if (m_empty.contains(g) || !holds(g)) {
        return;
    }
    const GatheredFacets& held = m_cache.held();
    float at[3];
    // Three roundings of half an ulp: position, box and their difference.
    const float rounding = 2e-7f * (asFloats(g, held.origin(), at) + held.reach_mm());
    const core::Box& region = held.region();
    const double half = std::min({static_cast<double>(boxDistance(held.groups(), held.count(), at) - rounding),
                                  (region.max() - g).minCoeff(), (g - region.min()).minCoeff()}) -
                        kPlate * layer.skin_mm; // distance from a facet at which it may still block
    m_empty.setEmpty();
    if (half > 0.0) {
        m_empty = core::Box(g.array() - half, g.array() + half);
    }
}

void NearPoint::lookAround(const HapticLayer& layer, std::uint32_t structure, const Vec3& p) noexcept
{
    // The box is as large as the other structures permit. The god-object eventually leaves the box.
    constexpr double kFirst = 8.0, kLeast = 2.0, kMost = 32.0; // facets
    Around& around = m_around;
    const double facet = layer.facetSize_mm;
    around.half_mm = around.half_mm == 0.0 ? kFirst * facet
                     : around.isAlone      ? std::min(1.5 * around.half_mm, kMost * facet)
                                           : std::max(0.5 * around.half_mm, kLeast * facet);
    around.box = core::Box(p.array() - around.half_mm, p.array() + around.half_mm);
    around.structure = structure;
    around.isAlone = true;
    const double reach = around.half_mm + kMaxQueryRadius * layer.skin_mm;
    const core::Box query(p.array() - reach, p.array() + reach);
    layer.hierarchy.visitBox(query, [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t s = first; s < first + count && around.isAlone; ++s) {
            if (layer.structures[s] != structure) {
                layer.surface(layer.structures[s])
                    .hierarchy()
                    .visitBox(query, [&around](std::uint32_t /*first*/, std::uint32_t /*count*/) {
                        return around.isAlone = false;
                    });
            }
        }
        return around.isAlone;
    });
}

void NearPoint::offerHeld(const HapticLayer& layer, First& first) const noexcept
{
    const GatheredFacets& held = m_cache.held();
    float x[3], y[3];
    const float start = asFloats(first.x, held.origin(), x), end = asFloats(first.y, held.origin(), y);
    for (std::uint64_t lanes = crossedLanes(held.groups(), held.count(), x, y, start + end + held.reach_mm(),
                                            static_cast<float>(first.skin_mm));
         lanes != 0; lanes &= lanes - 1) {
        const int i = std::countr_zero(lanes);
        first.offer(layer.surface(held.structure(i)), held.structure(i), held.triangle(i));
    }
}

void NearPoint::reach(const HapticLayer& layer, const Vec3& from, const Vec3& place, const Vec3& ahead) noexcept
{
    if (!holds(place) && !m_cache.takePrepared(layer, place, place)) {
        (void)m_cache.gather(layer, planFor(layer), from, ahead);
    }
}

std::size_t NearPoint::freeMoves(const HapticLayer& layer, std::span<const Vec3> path,
                                 std::span<const FacetNumber> walked) noexcept
{
    std::size_t moves = path.size() - 1;
    Crossing crossing;
    if (!std::all_of(path.begin(), path.end(), [this](const Vec3& p) { return holds(p); })) {
        for (std::size_t i = 0; i < moves; ++i) {
            if (ask(layer, path[i], path[i + 1], crossing, aroundMove(walked, i)) != Sweep::Free) {
                return i;
            }
        }
        return moves;
    }
    const GatheredFacets& held = m_cache.held();
    float points[kMaxPoints][3];
    float coordinate = 0.0f;
    for (std::size_t i = 0; i < path.size(); ++i) {
        coordinate = std::max(coordinate, asFloats(path[i], held.origin(), points[i]));
    }
    std::uint64_t lanes = crossedLanes(held.groups(), held.count(), points, static_cast<int>(path.size()),
                                       2.0f * coordinate + held.reach_mm(), static_cast<float>(layer.skin_mm));
    for (; lanes != 0; lanes &= lanes - 1) {
        const int k = std::countr_zero(lanes);
        const bool isWalked = isAmong(walked, held.structure(k), held.triangle(k));
        if (isWalked && walked.size() <= 3 &&
            isAmong(walked.last(walked.size() - 1), held.structure(k), held.triangle(k))) {
            continue; // at most two moves, none of which is blocked by the facets at its ends
        }
        const geometry::SurfaceIndex& surface = layer.surface(held.structure(k));
        const geometry::Triangle t = surface.triangle(held.triangle(k));
        const Vec3& a = surface.vertex(t[0]);
        const Vec3 n = (surface.vertex(t[1]) - a).cross(surface.vertex(t[2]) - a);
        const bool isTwoSided = surface.isTwoSided(held.triangle(k));
        for (std::size_t i = 0; i < moves; ++i) {
            if (!isTwoSided && endsInFront(n, n.dot(path[i + 1] - a), layer.skin_mm)) {
                continue; // most facets
            }
            if (isWalked && isAmong(aroundMove(walked, i), held.structure(k), held.triangle(k))) {
                continue;
            }
            if (blocks(facet(layer, k), path[i], path[i + 1], 1.0, crossing)) {
                moves = i;
            }
        }
    }
    return moves;
}

/// Finds the cached facets nearby, sorted by structure and triangle, because the order in which facets were gathered
/// depends on the region.
int NearPoint::near(const HapticLayer& layer, const Vec3& g, double reach_mm, std::array<int, kHeld>& found) noexcept
{
    if (m_work.isSpent()) {
        return 0;
    }
    m_work.spend(2 * kSweepPrice);
    // Each attempt halves a region that contains too many facets. The last attempt gathers only the queried position,
    // so that success there does not depend on the attempts before.
    for (int attempt = 0; attempt < 8 && !holds(g); ++attempt) {
        if (!m_cache.takePrepared(layer, g, g)) {
            (void)m_cache.gather(layer, planFor(layer), g, g);
        }
    }
    if (!holds(g) && !m_cache.gatherAt(layer, planFor(layer), g)) {
        return 0;
    }
    const GatheredFacets& held = m_cache.held();
    float at[3];
    const float coordinate = std::max(held.reach_mm(), asFloats(g, held.origin(), at));
    int count = 0;
    for (std::uint64_t lanes =
             nearLanes(held.groups(), held.count(), at, static_cast<float>(reach_mm), 2.0f * coordinate);
         lanes != 0; lanes &= lanes - 1) {
        found[static_cast<std::size_t>(count++)] = std::countr_zero(lanes);
    }
    std::sort(found.begin(), found.begin() + count, [&held](int i, int j) {
        return held.structure(i) != held.structure(j) ? held.structure(i) < held.structure(j)
                                                      : held.triangle(i) < held.triangle(j);
    });
    return count;
}

Sweep NearPoint::sweep(const HapticLayer& layer, const Vec3& x, const Vec3& y, Crossing& first,
                       std::span<const FacetNumber> walked) noexcept
{
    if (m_work.isSpent()) {
        return Sweep::Unknown;
    }
    m_work.spend(kSweepPrice);
    return ask(layer, x, y, first, walked);
}

Sweep NearPoint::ask(const HapticLayer& layer, const Vec3& x, const Vec3& y, Crossing& first,
                     std::span<const FacetNumber> walked) noexcept
{
    // Try the cached region first. If the move leaves this region, try the prepared one, and then gather along the
    // first part of the move.
    for (int attempt = 0; attempt < 3; ++attempt) {
        if (holds(x)) {
            const double share = insideFraction(m_cache.held().region(), x, y);
            First nearest{x, y, layer.skin_mm, first, walked, share};
            offerHeld(layer, nearest);
            if (nearest.found || share >= 1.0) {
                return nearest.found ? Sweep::Blocked : Sweep::Free;
            }
        }
        if (attempt == 0 && !m_cache.takePrepared(layer, x, x)) {
            ++attempt;
        }
        if (attempt == 1) {
            if ((y - x).cwiseAbs().maxCoeff() > kFarMove * layer.facetSize_mm) {
                break;
            }
            (void)m_cache.gather(layer, planFor(layer), x, y);
        }
    }
    return sweepAll(layer, First{x, y, layer.skin_mm, first, walked, 1.0});
}

Sweep NearPoint::sweepAll(const HapticLayer& layer, First nearest) noexcept
{
    constexpr double kEnd = -1.0;
    const std::uint32_t most = kSpared + m_work.left();
    const auto isSpent = [&] { return nearest.cost >= most; };
    layer.hierarchy.visitSegment(nearest.x, nearest.y, [&](std::uint32_t firstStructure, std::uint32_t structureCount) {
        for (std::uint32_t s = firstStructure; s < firstStructure + structureCount && !isSpent(); ++s) {
            const std::uint32_t number = layer.structures[s];
            const geometry::SurfaceIndex& surface = layer.surface(number);
            surface.hierarchy().visitSegment(
                nearest.x, nearest.y,
                [&](std::uint32_t i, std::uint32_t n) {
                    for (const std::uint32_t end = i + n; i < end; ++i) {
                        nearest.offer(surface, number, i);
                    }
                    if (isSpent() && !nearest.found) {
                        nearest.best.facet = Facet::of(surface, number, i - 1);
                        nearest.best.side = 1;
                    }
                    return isSpent() ? kEnd : nearest.limit;
                },
                layer.skin_mm);
        }
        return isSpent() ? kEnd : nearest.limit;
    });
    m_work.spend(nearest.cost > kSpared ? nearest.cost - kSpared : 0);
    return isSpent() ? Sweep::Unknown : nearest.found ? Sweep::Blocked : Sweep::Free;
}

} // namespace palpate::haptics::internal
