// SPDX-License-Identifier: BSD-3-Clause
#include "solver/PointTick.h"

#include "solver/Escape.h"
#include "solver/Walk.h"

#include <algorithm>
#include <array>
#include <utility>

namespace palpate::haptics::internal {

namespace {

constexpr std::uint32_t kPatience = 32; // moves that together must gain a skin
constexpr std::size_t kMostHeld = 3;    // contacts that a tick ends with
constexpr int kRounds = 3;              // rounds over a convex edge that together must gain a skin

} // namespace

void PointTick::touch(const PointContact& contact) noexcept
{
    m_active.add() = contact;
    m_mayWalk = contact.isInTheWay && (m_friction == nullptr || contact.supports(m_god)); // from a facet newly met
    m_skin_mm = std::max(m_skin_mm, contact.facet.skin_mm);
}

std::uint32_t PointTick::converge(std::uint32_t limit) noexcept
{
    const std::uint32_t moves = moveUntilDone(limit);
    if (m_active.isEmpty() && m_lastMet && (m_hip - m_god).cwiseAbs().maxCoeff() > m_lastMet->facet.skin_mm) {
        m_active.add() = *m_lastMet; // the facet that blocked last: away from the HIP a god-object is always held
    }
    return moves;
}

std::uint32_t PointTick::moveUntilDone(std::uint32_t limit) noexcept
{
    double spring = std::numeric_limits<double>::infinity();
    std::uint32_t i = 0;
    for (; i + m_walked < limit && !m_near.work().isSpent(); ++i) {
        if (i % kPatience == kPatience - 1) {
            // Planes that repeat each other to rounding can take turns for ever: a god-object that gains less than a
            // skin in so many moves has arrived.
            const double last = std::exchange(spring, (m_hip - m_god).norm());
            if (spring > last - m_skin_mm && !takeEscape()) {
                return i + 1 + m_walked;
            }
        }
        if (m_active.count() == 1 && m_mayWalk && walkHome(limit - i - m_walked)) {
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
            const bool isOnEdge = m_active.isEmpty() && countRound();
            if ((!stopAt(target, crossing) || isOnEdge) && !takeEscape()) {
                if (isOnEdge && m_friction != nullptr) {
                    holdByAllInTurn();
                }
                return i + 1 + m_walked;
            }
            meetInTurn({crossing.facet, crossing.side});
            continue;
        }
        if (m_active.isEmpty()) {
            m_god = target; // the HIP: nothing holds it short of that, be it by rounding
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

/// Walks on from the one contact, as long as walking is all there is to do. @return true when nothing is left.
bool PointTick::walkHome(std::uint32_t most) noexcept
{
    PointContact& contact = m_active[0];
    Facet beyond;
    Walk walk(m_hip, m_layer, m_near, m_friction, {m_god, contact.facet, beyond, contact.side});
    const Walk::Ended ended = walk.run(Walk::Start::OnFacet, most);
    m_walked += walk.moves();
    meetInTurn(contact);
    if (Walk::isHeldByTwo(ended)) {
        touch({beyond, contact.side});
    }
    m_mayWalk = false; // again from the next facet that is met
    return Walk::hasArrived(ended);
}

/// Where the HIP is nearest to a convex edge, each facet at it leads just beyond the edge and lets go there, and the
/// other is met by the straight way. @return true when that has come round a few times without gaining a skin.
bool PointTick::countRound() noexcept
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

/// Remembers a facet that was in the way, or that a walk has come to.
void PointTick::meetInTurn(const PointContact& contact) noexcept
{
    if (m_friction != nullptr) {
        m_inTurn[m_turn++ % m_inTurn.size()] = {{contact.facet.structure, contact.facet.triangle}, contact.side};
    }
}

/// Facets that block in turn hold the god-object together, each a part of the pull. Friction asks which.
void PointTick::holdByAllInTurn() noexcept
{
    for (std::size_t i = 0; i < std::min<std::size_t>(m_turn, m_inTurn.size()) && m_active.count() < kMostHeld; ++i) {
        const auto& [number, side] = m_inTurn[i];
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

/// What friction leaves of a move to the constrained point.
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
    const double r = slide.norm(), rounding = kRoundingOfMoves * m_skin_mm;
    const double left = m_friction->remainingShare(r, rounding);
    if (left < 1.0) {
        return u - left * slide;
    }
    // In a corner there is nothing for friction to hold: whether a way leads out is to be seen.
    m_isHeld = m_active.count() == 1 || r > rounding;
    return u;
}

/// Moves up to the facet in the way and takes its plane as a constraint.
/// @return false when that leads nowhere any more.
bool PointTick::stopAt(const Vec3& target, const Crossing& crossing) noexcept
{
    const PointContact met{crossing.facet, crossing.side, Footing::Away, true};
    m_skin_mm = std::max(m_skin_mm, met.facet.skin_mm);
    if (moveTo(m_god + crossing.stop * (target - m_god))) {
        keepSupporting();
    }
    // In place each new plane moves the constrained point away from the HIP, as in a dual active-set method: no set of
    // planes comes back.
    if (std::any_of(m_active.begin(), m_active.end(), [&met](const PointContact& c) { return c.isSame(met); })) {
        return false;
    }
    touch(met);
    return true;
}

/// @return false, unmoved, for less than rounding.
bool PointTick::moveTo(const Vec3& p) noexcept
{
    const double most = (p - m_god).cwiseAbs().maxCoeff();
    if (most <= kRoundingOfMoves * m_skin_mm) {
        return false;
    }
    m_god = p;
    // Within a skin it is the same place: planes that are one to rounding are that far apart.
    if (most > m_skin_mm) {
        for (PointContact& contact : m_active) {
            contact.isInTheWay = false;
        }
    }
    return true;
}

/// Drops the contacts whose triangle is no longer below the god-object, unless it stood in the way of a move from here:
/// with others it may lie beside, met at a shallow angle; alone its foot is on its very edge, and a facet that blocks
/// is not let go of.
void PointTick::keepSupporting() noexcept
{
    // With several contacts the foot on one may lie at its very edge, where rounding must not decide.
    const double slack = m_active.count() > 1 ? m_skin_mm : 0.0;
    m_active.release([&](PointContact& c) {
        const double skin = c.facet.skin_mm, plate = c.facet.isTwoSided ? kPlate * skin : 0.0;
        c.footing = footingOn(c.facet, c.side, m_god, {kSupporting * skin, std::max(slack, plate), kTouched * skin});
        return c.footing == Footing::Away && !c.isInTheWay;
    });
}

/// True when the contacts alone show that no move comes closer: none, one with the foot well inside it, or two below
/// the god-object that share an edge and rise towards each other.
bool PointTick::isCertain() const noexcept
{
    return m_active.isEmpty() || (m_active.count() == 1 && m_active[0].footing == Footing::Inside) ||
           (m_active.count() == 2 && isConcaveEdge());
}

/// Both rise towards each other from a common edge, and the god-object stands between its ends: at an end a third may
/// fall away.
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
    const double margin = kTouched * m_skin_mm * along.norm();
    return along.dot(m_god - *end[0]) > margin && along.dot(*end[1] - m_god) > margin;
}

/// Where the planes leave no room: @return true when there is a way out all the same, and it was taken.
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
