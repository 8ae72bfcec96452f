// SPDX-License-Identifier: BSD-3-Clause
#include "solver/BallTick.h"

#include "probe/ConstrainedPoint.h"

#include <algorithm>
#include <limits>

namespace palpate::haptics::internal {

namespace {

// Convergence test: the ball has arrived when kPatience moves reduce the distance to the HIP by less than kArrivalGain
// skins or the fraction kSlight of the distance. Without this test, a ball pressed in by its own radius could roll
// around a vertex forever. kSlight bounds the error of the depth to 1e-8; the lateral error is the square root of twice
// that, 1.4e-4 of the distance.
constexpr std::uint32_t kPatience = 16;
constexpr double kArrivalGain = 4.0;
constexpr double kSlight = 1e-8;
// Minimum step in skins. kPatience steps of this length cannot gain kArrivalGain skins in total, so shorter steps are
// not made. Far from the origin such steps are rounding noise, and each could require all facets nearby to be tested.
constexpr double kShortest = kArrivalGain / kPatience;
// Maximum number of sideways moves per tick that gain less than kSlight and are still followed up.
constexpr int kMaxInsignificantMoves = 4;

// Steps are considered creeping when kCreeping consecutive steps point in the direction of the previous one (cosine
// above kSameDirection). The next step is then as long as all remaining ones together (secant estimate), but at most
// kLongest radii and kGrowth times the previous step or the last accepted long step, and is only used if that lengthens
// the step by the factor kLonger.
constexpr int kCreeping = 2;
constexpr double kSameDirection = 0.9;
constexpr double kLongest = 0.5;
constexpr double kGrowth = 16.0;
constexpr double kLonger = 1.01;

// A long step must lead nearer to the HIP within kTrial moves. Otherwise the step is taken back and the next is limited
// to kShorter times its length.
constexpr int kTrial = 6;
constexpr double kShorter = 0.25;

constexpr double kSeparationGap = 3.0;     // skins; a larger gap, including the regular one, ends a contact
constexpr int kMaxRolledFacets = 8;        // maximum number of facets rolled over per move
constexpr double kMaxRollGap = 1.0 / 16.0; // radii; maximum gap to a facet that the ball has rolled onto
constexpr double kAside = 1e-4; // radii; length of the sideways move that tests whether a ball at rest would roll
// Radii; maximum distance from an edge at which rounding decides on which side the ball stands.
constexpr double kBrink = 1e-7;

constexpr double kMaxIdleTravel =
    1e-3; // radii; a tick that moved farther than this but gained less than a skin is undone

// Radii; maximum distance to the next facet that counts as contact when the work budget is spent.
constexpr double kAtFacet = 0.01;

/// The line along which two contacts leave the ball free to move.
struct Trough
{
    Vec3 t = Vec3::Zero();  ///< unit direction; zero where the two contacts are nearly parallel
    double curvature = 0.0; ///< second derivative of 0.5 |HIP - centre|^2 along the line while both contacts are kept

    /// @param push  sum of the multipliers times the normals [mm]
    Trough(const BallContact& p, const BallContact& q, const Vec3& push) noexcept
    {
        const Vec3 across = p.n.cross(q.n);
        const double sine2 = across.squaredNorm();
        if (sine2 < 1e-12) {
            return; // normals within 1e-6 rad: the direction of their line would be determined by rounding
        }
        // Second derivative of the Lagrangian: 1 minus the curvature terms of the two contacts.
        t = across / std::sqrt(sine2);
        const double cosine = p.n.dot(q.n), onP = p.n.dot(push), onQ = q.n.dot(push);
        const auto bend = [this](const BallContact& c, double multiplier) {
            const double edge = c.nearest.along.dot(t);
            return c.nearest.isCurved ? multiplier / c.distance_mm * (1.0 - edge * edge) : 0.0;
        };
        curvature = 1.0 - bend(p, (onP - cosine * onQ) / sine2) - bend(q, (onQ - cosine * onP) / sine2);
    }
};

} // namespace

void BallContact::updateFrom(const Vec3& g) noexcept
{
    nearest = nearestOn(facet, g);
    if (nearest.isCurved) {
        distance_mm = nearest.away.norm();
        // With the centre on the facet itself, to rounding, the direction is undefined. Use the facet's normal, as in
        // the first contact.
        n = distance_mm > kPlaneTolerance * facet.skin_mm ? Vec3(nearest.away / distance_mm) : Vec3(side * facet.n);
    } else {
        n = side * facet.n;
        distance_mm = n.dot(g - facet.a);
        if (facet.isTwoSided && distance_mm < -kPlaneTolerance * facet.skin_mm) { // the ball has come around the rim
            side = -side;
            n = -n;
            distance_mm = -distance_mm;
        }
    }
}

void BallTick::touch(const Facet& facet, int side) noexcept
{
    BallContact& contact = m_active.add();
    contact.facet = facet;
    contact.side = side;
    contact.radius_mm = radiusOff(m_room, m_layer, facet.structure, facet.triangle);
    contact.updateFrom(m_god);
    keepThinnest(facet.skin_mm);
}

/// Uses the smallest skin of all touched structures: a distance within rounding of a large structure can be significant
/// for a small one.
void BallTick::keepThinnest(double skin_mm) noexcept
{
    m_skin_mm = m_skin_mm > 0.0 ? std::min(m_skin_mm, skin_mm) : skin_mm;
}

/// Updates the contacts to the current position of the ball and drops those that the ball has left.
/// @return true if the contacts are unchanged
bool BallTick::updateContacts() noexcept
{
    bool isSame = true;
    m_active.release([&](BallContact& c) {
        c.updateFrom(m_god);
        if (isTouched(c)) {
            return false;
        }
        isSame = false;
        return !rollOn(c);
    });
    return isSame;
}

/// After the ball has rolled over an edge or a corner, replaces the contact by the facet, edge or corner that is now
/// below the ball, so that the next move leads down to this feature.
/// @return false if there is none nearby
bool BallTick::rollOn(BallContact& contact) const noexcept
{
    using Index = geometry::SurfaceIndex;
    const Index& surface = m_layer.surface(contact.facet.structure);
    for (int i = 0; i < kMaxRolledFacets && contact.nearest.isCurved; ++i) {
        // Around a corner, always traverse the facets in the same direction.
        const int edge = contact.nearest.corner >= 0 ? contact.nearest.corner : contact.nearest.edge;
        const Index::Neighbour next = surface.neighbour(contact.facet.triangle, static_cast<std::uint32_t>(edge));
        if (next.triangle == Index::kNoNeighbour) {
            return false;
        }
        contact.facet = Facet::of(surface, contact.facet.structure, next.triangle);
        contact.updateFrom(m_god);
        if (contact.nearest.edge == static_cast<int>(next.edge)) {
            break; // above the edge itself
        }
    }
    const double radius = contact.radius_mm;
    return contact.distance_mm > radius && contact.distance_mm < (1.0 + kMaxRollGap) * radius;
}

Vec3 BallTick::nextMove() noexcept
{
    const Vec3 wanted = m_hip - m_god;
    if (m_active.isEmpty()) {
        return wanted;
    }
    const Vec3 u = m_active.constrain(wanted, [](const BallContact& c) {
        const double missing = c.radius_mm + c.facet.skin_mm - c.distance_mm;
        return HalfSpace{c.n, missing <= kMaxPressedDepth * c.facet.skin_mm ? missing : 0.0};
    });
    if (m_active.isEmpty()) {
        return u;
    }
    return lengthened(m_friction == nullptr ? u : slowed(u));
}

/// Shortens a step by friction. Around edges and corners the step vanishes where the pull is on the boundary of the
/// friction cone.
Vec3 BallTick::slowed(const Vec3& u) noexcept
{
    m_friction->lift();
    for (std::size_t i = 0; i < m_active.count(); ++i) {
        m_friction->press(m_active[i].facet, m_active[i].nearest.q, m_active.lambda_mm(i));
    }
    const Vec3 slide = m_active.freePart(u);
    const double left = m_friction->remainingFraction(slide.norm(), kMinMove * m_skin_mm);
    const Vec3 down = u - slide;
    if (isDeep()) {
        return u; // the ball was placed inside the tissue, where friction does not hold
    }
    // A facet that the ball has rolled onto but not reached yet does not hold by friction: move straight down to the
    // facet.
    m_isHeld = left == 1.0 && down.norm() <= (kSeparationGap - 1.0) * m_skin_mm &&
               std::all_of(m_active.begin(), m_active.end(), [this](const BallContact& c) { return isTouched(c); });
    return m_isHeld ? Vec3::Zero() : Vec3(down + (1.0 - left) * slide);
}

/// Lengthens a creeping step. Steps creep because the contact planes turn with the rolling ball. The new length is the
/// root of the secant: the distance at which the step would become zero if it kept shrinking as the last one did.
Vec3 BallTick::lengthened(const Vec3& u) noexcept
{
    m_step = {m_god, u, m_active.count(), 0};
    const Vec3 moved = m_god - m_last.god;
    const double step = u.norm(), length = moved.norm();
    if (m_active.count() != m_last.count || moved.dot(u) <= kSameDirection * length * step) {
        return u;
    }
    m_step.alike = m_last.alike + 1;
    if (m_trialMoves > 0 || m_step.alike < kCreeping || staysFlat(u) || isDeep()) {
        return u;
    }
    const double shrunk = moved.dot(m_last.u - u);
    const double most =
        std::min({m_longest_mm, kLongest * m_layer.fingertip_mm, kGrowth * std::max(length, m_kept_mm)});
    const double whole = length * length * step < most * shrunk ? length * length * step / shrunk : most;
    if (whole <= kLonger * step) {
        return u;
    }
    m_before = {m_god, m_active, (m_hip - m_god).norm()};
    m_trialMoves = kTrial;
    m_tried_mm = whole;
    return whole / step * u;
}

/// Accepts or rejects a long step by the position reached since.
/// @param isOver  the tick has come to its end
/// @return false if the step was taken back
bool BallTick::judgeLongStep(bool isOver) noexcept
{
    if (m_trialMoves == 0) {
        return true;
    }
    if ((m_hip - m_god).norm() < m_before.spring_mm + kSeparationGap * m_skin_mm) {
        m_trialMoves = 0;
        m_kept_mm = m_tried_mm;
        m_longest_mm = std::max(m_longest_mm, m_tried_mm / kShorter);
        return true;
    }
    if (--m_trialMoves > 0 && !isOver) {
        return true;
    }
    m_trialMoves = 0;
    m_kept_mm = 0.0;
    m_longest_mm = kShorter * m_tried_mm;
    restoreSnapshot(m_before);
    return false;
}

/// Returns the direction from a contact point on a face to a convex edge within kBrink, zero if there is none. Rounding
/// decides on which side of such an edge the ball stands.
Vec3 BallTick::brink(const BallContact& contact) const noexcept
{
    using Index = geometry::SurfaceIndex;
    const Facet& facet = contact.facet;
    const Index& surface = m_layer.surface(facet.structure);
    const std::array<const Vec3*, 3> corner{&facet.a, &facet.b, &facet.c};
    for (std::uint32_t edge = 0; edge < 3; ++edge) {
        const Vec3& a = *corner[edge];
        const Vec3 out = (*corner[(edge + 1) % 3] - a).cross(facet.n).normalized();
        if (out.dot(a - contact.nearest.q) > kBrink * m_layer.fingertip_mm) {
            continue;
        }
        const Index::Neighbour next = surface.neighbour(facet.triangle, edge);
        if (next.triangle == Index::kNoNeighbour) {
            return out;
        }
        const Facet beyond = Facet::of(surface, facet.structure, next.triangle);
        for (const Vec3* v : {&beyond.a, &beyond.b, &beyond.c}) {
            if (contact.n.dot(*v - contact.nearest.q) < -kSeparationGap * facet.skin_mm) {
                return out;
            }
        }
    }
    return Vec3::Zero();
}

/// Returns the direction in which the ball would roll off its contacts if the pull passes straight through an edge or a
/// corner and out beyond, zero if the ball cannot roll.
Vec3 BallTick::slope() const noexcept
{
    const BallContact &p = m_active[0], &q = m_active[1];
    if (m_active.count() == 1 && p.distance_mm + p.n.dot(m_hip - m_god) < 0.0) {
        if (!p.nearest.isCurved) {
            return brink(p);
        }
        return p.nearest.along.isZero(0.0) ? p.n.unitOrthogonal() : Vec3(p.nearest.along.cross(p.n));
    }
    if (m_active.count() == 2 && (p.nearest.isCurved || q.nearest.isCurved)) {
        const Trough trough(p, q, m_god - m_hip);
        return trough.curvature > 0.0 ? Vec3::Zero() : trough.t; // held by a valley
    }
    return Vec3::Zero();
}

/// Restores a snapshot: the moves since then gained nothing.
void BallTick::restoreSnapshot(const Before& stood) noexcept
{
    m_god = stood.god;
    m_active = stood.active;
}

/// Moves a ball at rest sideways, first to one side and then to the others, by a distance that only serves to detect
/// whether the ball would roll.
/// @return true if there is another side to try; otherwise the ball is back at its rest position
bool BallTick::tryAside() noexcept
{
    if (m_friction != nullptr && m_friction->holdsAgainst(kMinMove * m_skin_mm)) {
        return false; // a ball held by friction does not roll
    }
    const double spring = (m_hip - m_god).norm();
    if (m_nudges == 0 && isNearest(spring)) {
        return false;
    }
    if (m_nudges == 0 || spring < m_restSnapshot.spring_mm - m_skin_mm) {
        if (m_nudges > 0 && spring >= m_restSnapshot.spring_mm - slight(spring) &&
            ++m_insignificantMoves > kMaxInsignificantMoves) {
            return false;
        }
        m_nudges = 0;
        m_aside = slope();
        m_restSnapshot = {m_god, m_active, spring};
    } else {
        restoreSnapshot(m_restSnapshot);
    }
    const int sides = m_active[0].nearest.along.isZero(0.0) && m_active.count() == 1
                          ? 4
                          : 2; // at a corner, also the two perpendicular directions
    while (m_nudges < sides && !m_aside.isZero(0.0)) {
        if (m_nudges == 2) {
            m_aside = m_active[0].n.cross(m_aside);
        }
        const double aside = m_nudges++ % 2 == 0 ? kAside : -kAside;
        const Vec3 target = m_god + aside * m_layer.fingertip_mm * m_aside;
        BallCrossing crossing;
        if (m_near.sweep(m_layer, m_room, m_god, target, m_work, crossing) == Sweep::Free) {
            m_god = target;
            (void)updateContacts();
            m_since = 0;
            return true;
        }
    }
    return false;
}

std::uint32_t BallTick::converge(std::uint32_t limit) noexcept
{
    m_near.beginTick();
    if (!m_active.isEmpty()) {
        m_known = m_active[0];
        m_isKnown = true;
    }
    (void)updateContacts();
    const Before began{m_god, m_active, (m_hip - m_god).norm()};
    std::uint32_t moves = 0;
    while (moves < limit) {
        ++moves;
        if (!makeMove()) {
            break;
        }
    }
    if (judgeLongStep(true) && m_nudges > 0 && (m_hip - m_god).norm() > m_restSnapshot.spring_mm) {
        restoreSnapshot(m_restSnapshot);
    }
    const double end = (m_hip - m_god).norm();
    if (!began.active.isEmpty() && end > began.spring_mm - m_skin_mm &&
        (m_god - began.god).norm() > kMaxIdleTravel * m_layer.fingertip_mm) {
        restoreSnapshot(began); // The moves gained nothing: when the HIP rests, the ball rests.
    }
    dropUntouched();
    if (m_active.isEmpty() && m_isKnown && m_god != m_hip) {
        // Away from the HIP the ball must have a contact: use the last facet known.
        touch(m_known.facet, m_known.side);
    }
    return moves;
}

/// Drops the contacts that the ball has rolled towards but not reached, unless no other contact remains.
void BallTick::dropUntouched() noexcept
{
    for (BallContact& contact : m_active) {
        contact.updateFrom(m_god);
    }
    // A contact that prevents a last insignificant gain is as near as it will get. Friction needs this contact, so it
    // is kept.
    const double gain_mm = slight((m_hip - m_god).norm());
    const auto isParted = [&](const BallContact& c) {
        return !isTouched(c) && !(m_friction != nullptr && c.distance_mm <= c.radius_mm + gain_mm);
    };
    if (!std::all_of(m_active.begin(), m_active.end(), isParted)) {
        m_active.release(isParted);
    }
}

/// Returns true if the HIP is a contact point, which is the smallest possible distance. On an edge or a corner the ball
/// could otherwise roll around the HIP forever without gain.
bool BallTick::touchesHip(double spring_mm) const noexcept
{
    const double enough = 0.5 * slight(spring_mm);
    return !isDeep() && std::any_of(m_active.begin(), m_active.end(), [&](const BallContact& c) {
        return spring_mm <= c.radius_mm + kSeparationGap * m_skin_mm + enough && (m_hip - c.nearest.q).norm() <= enough;
    });
}

/// Returns true if no legal position is significantly nearer to the HIP: the ball keeps its radius from every point of
/// the touched facets, including the point nearest to the HIP.
bool BallTick::isNearest(double spring_mm) const noexcept
{
    const double gain_mm = slight(spring_mm);
    return std::any_of(m_active.begin(), m_active.end(), [&](const BallContact& c) {
        return (m_hip - nearestOn(c.facet, m_hip).q).norm() <= c.radius_mm + gain_mm - spring_mm;
    });
}

/// Returns the smallest significant gain at this distance from the HIP [mm].
double BallTick::slight(double spring_mm) const noexcept
{
    return std::max(kArrivalGain * m_skin_mm, kSlight * spring_mm);
}

/// Makes one move of the tick.
/// @return false if there is no move left to make, or no work budget to make it with
bool BallTick::makeMove() noexcept
{
    if (m_work.isSpent()) {
        return false;
    }
    (void)judgeLongStep(false);
    const double now = (m_hip - m_god).norm();
    if (touchesHip(now)) {
        return false;
    }
    if (now < m_spring_mm - slight(now)) {
        m_spring_mm = now;
        m_since = 0;
    } else if (++m_since > kPatience && !m_active.isEmpty() && judgeLongStep(true)) {
        return tryAside();
    }
    const Vec3 u = nextMove();
    if (m_isHeld) {
        return !judgeLongStep(true);
    }
    const double step = u.cwiseAbs().maxCoeff();
    if (!m_active.isEmpty() && step <= kShortest * m_skin_mm) {
        return !judgeLongStep(true) || tryAside();
    }
    const bool isLong = m_trialMoves == kTrial;
    const Vec3 target = m_active.isEmpty() ? m_hip : Vec3(m_god + u);
    BallCrossing crossing;
    switch (m_near.sweep(m_layer, m_room, m_god, target, m_work, crossing)) {
    case Sweep::Free:
        return moveTo(target, isLong);
    case Sweep::Blocked:
        return stopAt(u, step, crossing, isLong);
    case Sweep::Unknown:
        break;
    }
    // The move is free up to crossing.stop, as far as it was tested. The next known facet becomes the contact if the
    // ball cannot get any farther, or if only the gap left by the bounds of the boxes separates the ball from that
    // facet.
    const bool isThere = (crossing.key - crossing.stop) * u.norm() <= kAtFacet * m_layer.fingertip_mm;
    if (crossing.key <= 1.0 && (isThere || crossing.stop * step <= kMinMove * m_skin_mm)) {
        (void)stopAt(u, step, crossing, isLong);
    } else if (crossing.stop > 0.0) {
        m_god += crossing.stop * u;
        (void)updateContacts();
    }
    return false;
}

/// Makes a move that nothing blocks.
/// @return false if the ball is at rest
bool BallTick::moveTo(const Vec3& target, bool isLong) noexcept
{
    const bool wasFlat = isFlat();
    if (!m_active.isEmpty()) {
        m_last = m_step;
    }
    m_god = target;
    return !(updateContacts() && wasFlat && isFlat() && !isLong && judgeLongStep(true) && !tryAside());
}

/// Moves up to the blocking facet and makes that facet a contact.
/// @return false if further moves gain nothing
/// @param step  largest component of u by magnitude [mm]
bool BallTick::stopAt(const Vec3& u, double step, const BallCrossing& crossing, bool isLong) noexcept
{
    keepThinnest(crossing.facet.skin_mm);
    const bool hasMoved = crossing.stop * step > kMinMove * m_skin_mm;
    if (hasMoved) {
        m_god += crossing.stop * u;
        (void)updateContacts();
    } else if (isLong) {
        m_trialMoves = 0;
        m_longest_mm = kShorter * m_tried_mm;
    }
    const bool isHeld = std::any_of(m_active.begin(), m_active.end(), [&](const BallContact& c) {
        return c.facet.structure == crossing.facet.structure && c.facet.triangle == crossing.facet.triangle;
    });
    if (isHeld) {
        return hasMoved || isLong || !judgeLongStep(true);
    }
    touch(crossing.facet, crossing.side);
    m_known = m_active[m_active.count() - 1];
    m_isKnown = true;
    if (m_friction != nullptr && !hasMoved) {
        // A facet that the ball rolled onto but cannot reach from here holds nothing; the blocking facet does.
        m_active.release([this](const BallContact& c) { return !isTouched(c); });
        if (m_active.isEmpty()) {
            m_active.add() = m_known;
        }
    }
    return true;
}

bool BallTick::isTouched(const BallContact& contact) const noexcept
{
    const double skin = contact.facet.skin_mm;
    // A one-sided facet does not hold a ball behind its plane.
    return contact.distance_mm >= -kPlaneTolerance * skin &&
           contact.distance_mm <= contact.radius_mm + kSeparationGap * skin;
}

/// Returns true if the ball is nearer to a contact than its radius: the ball was placed there, and each move must
/// increase the distance.
bool BallTick::isDeep() const noexcept
{
    return std::any_of(m_active.begin(), m_active.end(), [&](const BallContact& c) {
        return c.radius_mm + c.facet.skin_mm - c.distance_mm > kMaxPressedDepth * c.facet.skin_mm;
    });
}

bool BallTick::isFlat() const noexcept
{
    return std::none_of(m_active.begin(), m_active.end(), [](const BallContact& c) { return c.nearest.isCurved; });
}

/// Returns true if the ball touches only faces, both here and at the end of the step. Their planes then represent the
/// surface exactly.
bool BallTick::staysFlat(const Vec3& u) const noexcept
{
    return isFlat() && std::none_of(m_active.begin(), m_active.end(),
                                    [&](const BallContact& c) { return nearestOn(c.facet, m_god + u).isCurved; });
}

} // namespace palpate::haptics::internal
