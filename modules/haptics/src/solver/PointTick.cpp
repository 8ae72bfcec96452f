// SPDX-License-Identifier: BSD-3-Clause
#include "solver/PointTick.h"

#include "solver/Escape.h"
#include "solver/Walk.h"

#include <algorithm>
#include <array>
#include <utility>

namespace palpate::haptics::internal {

namespace {

constexpr std::uint32_t kPointPatience = 32; // moves that must gain a skin in total
constexpr std::size_t kMostHeld = 3;         // maximum number of contacts at the end of a tick
constexpr int kRounds = 3;                   // cycles over a convex edge that must gain a skin in total

} // namespace

void PointTick::touch(const PointContact& contact) noexcept
{
    m_active.add() = contact;
    m_mayWalk = contact.isInTheWay && (m_friction == nullptr || contact.supports(m_god)); // only from a newly met facet
    m_skin_mm = std::max(m_skin_mm, contact.facet.skin_mm);
}

std::uint32_t PointTick::converge(std::uint32_t limit) noexcept
{
    const std::uint32_t moves = moveUntilDone(limit);
    if (m_active.isEmpty() && m_lastMet && (m_hip - m_god).cwiseAbs().maxCoeff() > m_lastMet->facet.skin_mm) {
        m_active.add() = *m_lastMet; // away from the HIP a god-object always has a contact: the facet that blocked last
    }
    return moves;
}

std::uint32_t PointTick::moveUntilDone(std::uint32_t limit) noexcept
{
    double spring = std::numeric_limits<double>::infinity();
    std::uint32_t i = 0;
    for (; i + m_walked < limit && !m_near.work().isSpent(); ++i) {
        if (i % kPointPatience == kPointPatience - 1) {
            // Nearly coplanar planes may alternate forever. A god-object that gains less than a skin in kPointPatience
            // moves has arrived.
            const double last = std::exchange(spring, (m_hip - m_god).norm());
            if (spring > last - m_skin_mm && !takeEscape()) {
                return i + 1 + m_walked;
            }
        }
        if (m_active.count() == 1 && m_mayWalk && walkToRest(limit - i - m_walked)) {
            return i + m_walked;
        }
        if (i + m_walked >= limit || m_near.work().isSpent()) {
            break;
        }
        const Vec3 target = nextTarget();
        if (m_isHeld) {
            return i + 1 + m_walked;
        }
        Crossing crossing;
        const Sweep swept = m_near.sweep(m_layer, m_god, target, crossing);
        if (swept != Sweep::Free) {
            m_lastMet = {crossing.facet, crossing.side};
        }
        if (swept == Sweep::Unknown) {
            break;
        }
        if (swept == Sweep::Blocked) {
            const bool isOnEdge = m_active.isEmpty() && detectCycle();
            if ((!stopAt(target, crossing) || isOnEdge) && !takeEscape()) {
                if (isOnEdge && m_friction != nullptr) {
                    addBlockingContacts();
                }
                return i + 1 + m_walked;
            }
            recordBlocking({crossing.facet, crossing.side});
            continue;
        }
        if (m_active.isEmpty()) {
            m_god = target; // at the HIP, possibly only within rounding: no contact
            return i + 1 + m_walked;
        }
        moveTo(target);
        const std::size_t before = m_active.count();
        keepSupporting();
        if (m_active.count() == before && (isCertain() || !takeEscape())) {
            return i + 1 + m_walked;
        }
    }
    return i + m_walked;
}

/// Continues from a single contact by walking, as long as walking suffices.
/// @return true if the tick is complete
bool PointTick::walkToRest(std::uint32_t most) noexcept
{
    PointContact& contact = m_active[0];
    Facet beyond;
    Walk walk(m_hip, m_layer, m_near, m_friction, {m_god, contact.facet, beyond, contact.side});
    const Walk::Ended ended = walk.run(Walk::Start::OnFacet, most);
    m_walked += walk.moves();
    recordBlocking(contact);
    if (Walk::isHeldByTwo(ended)) {
        touch({beyond, contact.side});
    }
    m_mayWalk = false; // may be set again by the next facet met
    return Walk::hasArrived(ended);
}

/// Detects cycling. Where the HIP is nearest to a convex edge, each of the two facets leads just beyond the edge and is
/// released there, and the straight move then meets the other facet.
/// @return true if several cycles gained less than a skin
bool PointTick::detectCycle() noexcept
{
    const double spring = (m_hip - m_god).norm();
    if (spring < m_letGo_mm - m_skin_mm) {
        m_letGo_mm = spring;
        m_rounds = 0;
        m_turn = 0;
        return false;
    }
    return ++m_rounds >= kRounds;
}

/// Records a facet that blocked a move or was reached by a walk.
void PointTick::recordBlocking(const PointContact& contact) noexcept
{
    if (m_friction != nullptr) {
        m_recentBlocking[m_turn++ % m_recentBlocking.size()] = {{contact.facet.structure, contact.facet.triangle},
                                                                contact.side};
    }
}

/// Makes contacts of all facets that blocked in turn. Together they hold the god-object, each against a part of the
/// pull, and friction must know all of them.
void PointTick::addBlockingContacts() noexcept
{
    for (std::size_t i = 0; i < std::min<std::size_t>(m_turn, m_recentBlocking.size()) && m_active.count() < kMostHeld;
         ++i) {
        const auto& [number, side] = m_recentBlocking[i];
        const PointContact other{Facet::of(m_layer.surface(number.structure), number.structure, number.triangle), side};
        if (std::none_of(m_active.begin(), m_active.end(), [&](const PointContact& c) { return c.isSame(other); })) {
            m_active.add() = other;
        }
    }
}

Vec3 PointTick::nextTarget() noexcept
{
    if (m_active.isEmpty()) {
        return m_hip;
    }
    const Vec3 wanted = m_hip - m_god;
    const Vec3 u = m_active.constrain(wanted, [this](const PointContact& c) { return c.planeFrom(m_god); });
    return m_god + (m_friction == nullptr || m_active.isEmpty() ? u : slowed(u));
}

/// Shortens a move to the constrained point by friction.
Vec3 PointTick::slowed(const Vec3& u) noexcept
{
    m_friction->lift();
    bool isOn = false;
    for (std::size_t i = 0; i < m_active.count(); ++i) {
        if (m_active[i].supports(m_god)) {
            m_friction->press(m_active[i].facet, m_god, m_active.lambda_mm(i));
            isOn = true;
        }
    }
    if (!isOn) {
        return u;
    }
    const Vec3 slide = m_active.freePart(u);
    const double r = slide.norm(), rounding = kMinMove * m_skin_mm;
    const double left = m_friction->remainingFraction(r, rounding);
    if (left < 1.0) {
        return u - left * slide;
    }
    // In a corner no motion is left that friction could hold; an escape may still exist.
    m_isHeld = m_active.count() == 1 || r > rounding;
    return u;
}

/// Moves up to the blocking facet and adds its plane as a constraint.
/// @return false if no further move can gain
bool PointTick::stopAt(const Vec3& target, const Crossing& crossing) noexcept
{
    const PointContact met{crossing.facet, crossing.side, Footing::Away, true};
    m_skin_mm = std::max(m_skin_mm, met.facet.skin_mm);
    if (moveTo(m_god + crossing.stop * (target - m_god))) {
        keepSupporting();
    }
    // In one place, each new plane moves the constrained point away from the HIP, as in a dual active-set method, so
    // that no set of planes recurs.
    if (std::any_of(m_active.begin(), m_active.end(), [&met](const PointContact& c) { return c.isSame(met); })) {
        return false;
    }
    touch(met);
    return true;
}

/// Moves the god-object.
/// @return false, without a move, if the distance is rounding
bool PointTick::moveTo(const Vec3& p) noexcept
{
    const double most = (p - m_god).cwiseAbs().maxCoeff();
    if (most <= kMinMove * m_skin_mm) {
        return false;
    }
    m_god = p;
    // Positions within a skin count as the same place: planes that are equal up to rounding are that far apart.
    if (most > m_skin_mm) {
        for (PointContact& contact : m_active) {
            contact.isInTheWay = false;
        }
    }
    return true;
}

/// Drops the contacts whose triangle is no longer below the god-object, unless the facet blocked a move from here. Such
/// a facet may be beside the god-object, met at a shallow angle together with others, or have its foot on the very edge
/// if alone; a blocking facet is never released.
void PointTick::keepSupporting() noexcept
{
    // With several contacts, the foot on one may be at the very edge of the facet, where rounding must not decide.
    const double slack = m_active.count() > 1 ? m_skin_mm : 0.0;
    m_active.release([&](PointContact& c) {
        const double skin = c.facet.skin_mm, plate = c.facet.isTwoSided ? kPlate * skin : 0.0;
        c.footing =
            footingOn(c.facet, c.side, m_god, {kSupporting * skin, std::max(slack, plate), kTouchRadius * skin});
        return c.footing == Footing::Away && !c.isInTheWay;
    });
}

/// Returns true if the contacts alone prove that no move leads closer: no contact, one contact with the foot well
/// inside, or two supporting contacts that form a concave edge.
bool PointTick::isCertain() const noexcept
{
    return m_active.isEmpty() || (m_active.count() == 1 && m_active[0].footing == Footing::Inside) ||
           (m_active.count() == 2 && isConcaveEdge());
}

/// Returns true if the two contacts form a concave edge and the god-object is between its ends. At an end, the surface
/// may fall away at a third facet.
bool PointTick::isConcaveEdge() const noexcept
{
    const PointContact &p = m_active[0], &q = m_active[1];
    if (p.footing == Footing::Away || q.footing == Footing::Away) {
        return false;
    }
    std::array<const Vec3*, 2> end{};
    std::size_t shared = 0;
    for (const Vec3* v : {&p.facet.a, &p.facet.b, &p.facet.c}) {
        if (*v != q.facet.a && *v != q.facet.b && *v != q.facet.c) {
            if (q.gap(*v) < 0.0) {
                return false;
            }
        } else if (shared++ < end.size()) {
            end[shared - 1] = v;
        }
    }
    if (shared != end.size()) {
        return false;
    }
    const Vec3 along = *end[1] - *end[0];
    const double margin = kTouchRadius * m_skin_mm * along.norm();
    return along.dot(m_god - *end[0]) > margin && along.dot(*end[1] - m_god) > margin;
}

/// Tries to escape where the planes leave no room.
/// @return true if an escape was found and made
bool PointTick::takeEscape() noexcept
{
    Escape::End end;
    if (!Escape(m_hip, m_layer, m_near, m_god, m_skin_mm).find(m_active, end)) {
        return false;
    }
    if (m_friction != nullptr && m_friction->holdsAgainst((m_hip - m_god).dot((end.p - m_god).normalized()))) {
        return false;
    }
    moveTo(end.p);
    m_active.clear();
    for (const PointContact& contact : end.along) {
        touch({contact.facet, contact.side});
    }
    keepSupporting();
    if (end.isBlocked) {
        touch(end.next);
    }
    return true;
}

} // namespace palpate::haptics::internal
