// SPDX-License-Identifier: BSD-3-Clause
#include "nearby/TightRoom.h"

#include "probe/BallProbe.h"

#include <palpate/geometry/Inside.h>
#include <palpate/geometry/internal/BoxHierarchySwept.h>
#include <palpate/geometry/internal/BoxHierarchyVisit.h>

#include <algorithm>

namespace palpate::haptics::internal {

namespace {

constexpr double kFirstReach = 1.0 / 64.0; // of the search, as a share of the last
constexpr double kNextReach = 2.0;         // each further reach is this many times the previous one

// Prices in units of TickWork.
constexpr std::uint32_t kSearchNode = 10;
constexpr std::uint32_t kFarSearchNode = 26; // in a large layer, as in NearBall.cpp
constexpr std::uint32_t kSearchFacet = 4;    // distance of a facet, or its intersection with a ray
constexpr std::uint32_t kSearchRay = 50;     // traversal of one hierarchy by a ray

/// Returns true if the first one-sided facet of a surface on a ray shows its back: the ray starts inside.
bool startsBehind(const geometry::SurfaceIndex& surface, const Vec3& p, TickWork& work) noexcept
{
    const Vec3 along = Vec3(0.31, 0.53, 0.79).normalized(); // no axis or diagonal, along which models are often cut
    const core::Box& box = surface.bounds();
    const double length = 1.01 * ((box.center() - p).norm() + box.diagonal().norm());
    double first = length;
    bool isBack = false;
    work.spend(kSearchRay);
    surface.hierarchy().visitSegment(p, p + length * along, [&](std::uint32_t begin, std::uint32_t count) {
        work.spend(kSearchFacet * count);
        for (std::uint32_t i = begin; i < begin + count; ++i) {
            const geometry::Triangle t = surface.triangle(i);
            const Vec3 &a = surface.vertex(t[0]), &b = surface.vertex(t[1]), &c = surface.vertex(t[2]);
            const double at = geometry::distanceAlongRay(a, b, c, p, along);
            if (at < first && !surface.isTwoSided(i)) {
                first = at;
                isBack = (b - a).cross(c - a).dot(along) > 0.0;
            }
        }
        return work.isSpent() ? -1.0 : first / length;
    });
    return isBack;
}

} // namespace

TightRoom::Near* TightRoom::find(std::uint32_t structure, std::uint32_t part) noexcept
{
    const auto end = m_near.begin() + m_count;
    const auto found = std::find_if(m_near.begin(), end,
                                    [&](const Near& one) { return one.structure == structure && one.part == part; });
    return found == end ? nullptr : &*found;
}

double TightRoom::radiusOff(const HapticLayer& layer, std::uint32_t structure, std::uint32_t triangle) const noexcept
{
    const std::uint32_t part = layer.surface(structure).part(triangle);
    for (std::size_t i = 0; i < m_count; ++i) {
        if (m_near[i].structure == structure && m_near[i].part == part) {
            return m_near[i].radius_mm;
        }
    }
    return layer.fingertip_mm;
}

/// Enters a part that is too near, unless a search within a smaller reach has found it.
void TightRoom::note(std::uint32_t structure, std::uint32_t part, double radius_mm) noexcept
{
    if (Near* const near = find(structure, part)) {
        if (near >= m_near.data() + m_known) {
            near->radius_mm = std::min(near->radius_mm, radius_mm);
        }
    } else if (m_count < kMostParts) {
        m_near[m_count++] = {structure, part, radius_mm};
    } else {
        m_isFull = true;
    }
}

/// Enters the parts with a facet within reach, except for those that are known.
/// @return false if the work was spent before all facets were tested
bool TightRoom::searchWithin(const HapticLayer& layer, const Vec3& p, double reach_mm, TickWork& work) noexcept
{
    const std::uint32_t price = layer.isLarge ? kFarSearchNode : kSearchNode;
    const auto visitFacets = [&](std::uint32_t number, std::uint32_t first, std::uint32_t count) {
        work.spend(kSearchFacet * count);
        const geometry::SurfaceIndex& surface = layer.surface(number);
        for (std::uint32_t i = first; i < first + count; ++i) {
            const Facet facet = Facet::of(surface, number, i);
            if (!facet.isTwoSided && facet.n.dot(p - facet.a) < -kPlaneTolerance * facet.skin_mm) {
                continue; // faces away, as in blocksBall
            }
            const double distance = nearestOn(facet, p).away.norm();
            const double radius = std::max(facet.skin_mm, distance - facet.skin_mm);
            // Beyond the reach, a nearer facet of the same part may not be visited yet.
            if (distance <= reach_mm && layer.fingertip_mm - radius > kMaxPressedDepth * facet.skin_mm) {
                note(number, surface.part(i), radius);
            }
        }
        return !work.isSpent();
    };
    const std::uint32_t above = layer.hierarchy.visitAround(p, reach_mm, [&](std::uint32_t s, std::uint32_t n) {
        for (const std::uint32_t end = s + n; s < end && !work.isSpent(); ++s) {
            const std::uint32_t number = layer.structures[s];
            const geometry::SurfaceIndex& surface = layer.surface(number);
            if (m_known > 0 && !surface.hasSeveralParts() && find(number, 0) != nullptr) {
                continue;
            }
            work.spend(price *
                       surface.hierarchy().visitAround(p, reach_mm, [&](std::uint32_t first, std::uint32_t count) {
                           return visitFacets(number, first, count);
                       }));
        }
        return !work.isSpent();
    });
    work.spend(price * above);
    return !work.isSpent();
}

void TightRoom::search(const HapticLayer& layer, const Vec3& p, TickWork& work) noexcept
{
    m_count = m_known = 0;
    m_isFull = m_isWhole = false;
    const double farthest = layer.fingertip_mm + 2.0 * layer.skin_mm;
    for (double share = kFirstReach; share <= 1.0; share *= kNextReach) {
        if (!searchWithin(layer, p, share * farthest, work)) {
            m_count = m_known; // nearer facets of the others may be among those that were not tested
            return;
        }
        m_known = m_count;
    }
    const auto encloses = [&](std::uint32_t number) { return startsBehind(layer.surface(number), p, work); };
    m_isWhole = m_count == 0 && !m_isFull && std::none_of(layer.structures.begin(), layer.structures.end(), encloses) &&
                !work.isSpent();
}

} // namespace palpate::haptics::internal
