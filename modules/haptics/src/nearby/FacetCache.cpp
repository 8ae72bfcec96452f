// SPDX-License-Identifier: BSD-3-Clause
#include "nearby/FacetCache.h"

#include <algorithm>

namespace palpate::haptics::internal {

namespace {

using core::Vec3;

constexpr double kTicksAhead = 14.0;
constexpr double kMarginsAhead = 16.0; // maximum look-ahead for a fast motion
constexpr double kMarginsOfMove = 3.0; // part of a long move that is gathered at once
// Weight of the last tick in the mean motion: the facets make the god-object oscillate about its path.
constexpr double kNewest = 0.25;
// Finding, numbering and filling a typical region, spread over ticks.
constexpr double kTicksToPrepare = 5.0;
constexpr int kGroupsATick = 8;

core::Box around(const Vec3& x, const Vec3& y, const Vec3& z, double margin_mm) noexcept
{
    return {x.cwiseMin(y).cwiseMin(z).array() - margin_mm, x.cwiseMax(y).cwiseMax(z).array() + margin_mm};
}

} // namespace

void FacetCache::clear() noexcept
{
    m_sets[0].clear();
    m_sets[1].clear();
    m_hasLast = false;
    m_motion = Vec3::Zero();
    m_margin_mm = 0.0;
}

Vec3 FacetCache::ahead(const Vec3& from) const noexcept
{
    const double speed = m_motion.norm();
    return speed > 0.0 ? Vec3(from + m_motion * std::min(kTicksAhead, kMarginsAhead * m_margin_mm / speed)) : from;
}

void FacetCache::follow(const Vec3& g) noexcept
{
    if (m_hasLast) {
        m_motion += kNewest * (g - m_last - m_motion);
    }
    m_last = g;
    m_hasLast = true;
}

Vec3 FacetCache::soon() const noexcept
{
    return m_last + kTicksToPrepare * m_motion;
}

void FacetCache::prepare(const HapticLayer& layer, const GatheringPlan& plan, bool isNew) noexcept
{
    GatheredFacets& next = m_sets[1 - m_used];
    if (next.isBegun() && !next.isReady()) {
        next.proceed(layer, kGroupsATick);
        return;
    }
    const Vec3& g = m_last;
    const Vec3 then = soon();
    const bool isHeld = held().covers(g);
    if (m_margin_mm == 0.0) {
        m_margin_mm = layer.facetSize_mm;
    }
    if ((!isHeld && !isNew) || held().covers(then) || next.covers(then) ||
        kTicksToPrepare * m_motion.norm() > kMarginsAhead * m_margin_mm) {
        return;
    }
    const Vec3 from = isHeld ? Vec3(g + 0.5 * kTicksToPrepare * m_motion) : g;
    if (!next.begin(layer, around(from, from, ahead(from), m_margin_mm), from, plan.around_mm)) {
        m_margin_mm *= 0.5;
        return;
    }
    adapt(plan, next.count());
}

void FacetCache::adapt(const GatheringPlan& plan, int count) noexcept
{
    if (count > plan.many) {
        m_margin_mm = std::max(0.8 * m_margin_mm, std::min(m_margin_mm, plan.narrowest_mm));
    } else if (count < (m_margin_mm < plan.narrowest_mm ? plan.many / 2 : plan.few)) {
        m_margin_mm = std::min(1.25 * m_margin_mm, plan.widest_mm);
    }
}

bool FacetCache::takePrepared(const HapticLayer& layer, const Vec3& p, const Vec3& q) noexcept
{
    GatheredFacets& next = m_sets[1 - m_used];
    if (!next.covers(p) || !next.covers(q)) {
        return false;
    }
    next.finish(layer);
    m_sets[m_used].clear();
    m_used = 1 - m_used;
    return true;
}

bool FacetCache::gather(const HapticLayer& layer, const GatheringPlan& plan, const Vec3& x, const Vec3& y) noexcept
{
    if (m_margin_mm == 0.0) {
        m_margin_mm = layer.facetSize_mm;
    }
    const double length = (y - x).cwiseAbs().maxCoeff();
    const double most = kMarginsOfMove * std::max(m_margin_mm, layer.facetSize_mm);
    const Vec3 end = length > most ? Vec3(x + (y - x) * (most / length)) : y;
    GatheredFacets& facets = m_sets[m_used];
    if (!facets.begin(layer, around(x, end, length > most ? x : ahead(x), m_margin_mm), x, plan.around_mm)) {
        m_margin_mm *= 0.5;
        return false;
    }
    facets.finish(layer);
    // The shape of a region along a long move does not reflect the size of the facets.
    adapt(plan, length <= m_margin_mm ? facets.count() : std::min(facets.count(), plan.many));
    return true;
}

bool FacetCache::gatherAt(const HapticLayer& layer, const GatheringPlan& plan, const Vec3& p) noexcept
{
    GatheredFacets& facets = m_sets[m_used];
    const bool isAll = facets.begin(layer, {p, p}, p, plan.around_mm);
    facets.finish(layer);
    return isAll;
}

} // namespace palpate::haptics::internal
