// SPDX-License-Identifier: BSD-3-Clause
#include "solver/Escape.h"

#include "solver/VertexRing.h"

#include <algorithm>

namespace palpate::haptics::internal {

void Escape::addTouched(const Facet& facet, std::size_t held) noexcept
{
    const int side = facet.n.dot(m_god - facet.a) < 0.0 && facet.isTwoSided ? -1 : 1;
    const double reach = kTouched * facet.skin_mm; // feet may lie so far beside a facet
    if (footingOn(facet, side, m_god, {reach, reach, 0.0}) == Footing::Away) {
        return;
    }
    for (std::size_t i = 0; i < held; ++i) {
        if (m_touched[i].structure == facet.structure && m_touched[i].triangle == facet.triangle && m_side[i] == side) {
            return;
        }
    }
    if (m_count == m_touched.size()) {
        m_isRoom = false;
        return;
    }
    m_touched[m_count] = facet;
    m_side[m_count++] = side;
}

/// Collects the facets that are touched, the held ones first: they lead on more often.
/// @return true when those are all
bool Escape::gather(const PointContacts& held) noexcept
{
    for (const PointContact& contact : held) {
        m_touched[m_count] = contact.facet;
        m_side[m_count++] = contact.side;
    }
    const std::size_t count = m_count;
    return m_near.forEachNear(m_layer, m_god, kNearby * m_layer.skin_mm,
                              [&](const Facet& facet) { addTouched(facet, count); });
}

bool Escape::find(const PointContacts& held, End& end) noexcept
{
    const bool isKnown = gather(held);
    double skin = m_skin_mm;
    for (std::size_t i = held.count(); i < m_count; ++i) {
        skin = std::max(skin, m_touched[i].skin_mm);
    }
    // Within the skin's thickness a facet's very edge may stand in the way of what is open beyond it: the ways are
    // tried from a little above, away from the HIP.
    const Vec3 wanted = m_hip - m_god;
    const double spring = wanted.norm();
    m_most_mm = spring - kLeastGain * skin;
    Vec3 from = m_god - wanted * (kTouched * skin / spring);
    if (isKnown && m_isRoom && m_most_mm > 0.0 && isHeldByRing(touched(), from, m_hip - from, m_most_mm)) {
        return false;
    }
    Crossing above;
    const Sweep swept = m_near.sweep(m_layer, m_god, from, above);
    if (swept == Sweep::Unknown) {
        return false;
    }
    if (swept == Sweep::Blocked) {
        from = m_god + above.stop * (from - m_god);
    }
    if (follow(from, {}, end)) {
        return true;
    }
    const auto contact = [this](std::size_t i) { return PointContact{m_touched[i], m_side[i]}; };
    for (std::size_t i = 0; i < m_count; ++i) {
        if (follow(from, std::array{contact(i)}, end)) {
            return true;
        }
    }
    for (std::size_t i = 0; i < m_count; ++i) {
        for (std::size_t j = i + 1; j < m_count; ++j) {
            if (follow(from, std::array{contact(i), contact(j)}, end)) {
                return true;
            }
        }
    }
    return false;
}

/// Goes along the given planes alone, of those that are touched. @return false when that leads no nearer to the HIP
/// than is worth a move.
bool Escape::follow(Vec3 from, std::span<const PointContact> along, End& end) noexcept
{
    std::array<HalfSpace, 2> planes;
    const auto setPlanes = [&] {
        for (std::size_t i = 0; i < along.size(); ++i) {
            planes[i] = along[i].planeFrom(from);
        }
        return std::span<const HalfSpace>(planes).first(along.size());
    };
    const Vec3 pull = m_hip - from;
    if ((pull - constrainedPoint(pull, setPlanes(), allowance(m_skin_mm, pull)).u).norm() > m_most_mm) {
        return false; // most ways end here, without a sweep
    }
    // First to a skin above the planes themselves, where that is free: their edges are no longer in the way from there.
    Crossing crossing;
    const Vec3 up = constrainedPoint(Vec3::Zero(), setPlanes(), 0.0).u;
    if (!along.empty() && m_near.sweep(m_layer, from, from + up, crossing) == Sweep::Free) {
        from += up;
    }
    const Vec3 wanted = m_hip - from;
    const ConstrainedPoint point = constrainedPoint(wanted, setPlanes(), allowance(m_skin_mm, wanted));
    if ((wanted - point.u).norm() > m_most_mm) {
        return false;
    }
    Vec3 u = point.u;
    // A facet that is touched blocks most ways: no sweep is needed to see that.
    const auto stands = [&](const Facet& facet) { return blocks(facet, from, from + u, 0.0, crossing); };
    if (std::any_of(touched().begin(), touched().end(), stands)) {
        return false;
    }
    const Sweep swept = m_near.sweep(m_layer, from, from + u, crossing);
    if (swept == Sweep::Unknown) {
        return false;
    }
    end.isBlocked = swept == Sweep::Blocked;
    if (end.isBlocked) {
        u *= crossing.stop;
        if ((wanted - u).norm() > m_most_mm) {
            return false;
        }
        end.next = {crossing.facet, crossing.side};
    }
    end.p = from + u;
    end.along.clear();
    for (int i = 0; i < point.count; ++i) {
        end.along.add() = along[point.active[static_cast<std::size_t>(i)]];
    }
    return true;
}

} // namespace palpate::haptics::internal
