// SPDX-License-Identifier: BSD-3-Clause
#include "solver/GodObject.h"

#include "solver/BallTick.h"
#include "solver/PointTick.h"
#include "solver/Walk.h"

#include <algorithm>
#include <limits>
#include <span>

namespace palpate::haptics::internal {

namespace {

// A tick of a ball in contact prepares the caches of the next tick only if it spent at most this work [units of
// TickWork]. A lower limit leaves ticks of several moves unprepared, a higher limit lengthens the longest ticks
// (bench_touch, ball4: from 450 to 1,100).
constexpr std::uint32_t kLight = 800;

// Work for the search for the room of a ball: a quarter of a tick's. Always the same, because a part that is not found
// counts as one with room: what is found must not depend on the work of other layers. At most a share of what is left
// of the tick is charged, so that the ball can always move.
constexpr std::uint32_t kSearch = 5500;
constexpr std::uint32_t kShareOfSearch = 4;

} // namespace

/// God-object at the start of a tick. `structure` and `triangle` of the state only change in `publish`.
struct GodObject::Before
{
    Vec3 p_WG;
    std::array<std::int8_t, 3> side;
    std::uint8_t constraints;
};

GodObjectStep GodObject::step(const Vec3& p_WH, double dt_s, const HapticLayer& layer, const GodObjectLimits& limits,
                              NearBall* ball) noexcept
{
    if (m_state.placed != GodObjectState::kPlaced && m_room == nullptr) [[unlikely]] {
        return stepTight(p_WH, dt_s, layer, limits, ball);
    }
    GodObjectStep result;
    recallFacets(layer);
    if (m_state.constraints == 0 && layer.fingertip_mm == 0.0 && limits.work > NearPoint::kSweepPrice &&
        m_near.isFree(m_state.p_WG, p_WH)) {
        m_state.p_WG = p_WH;
        m_state.slides = 0;
        result.iterations = 1;
        result.work = NearPoint::kSweepPrice; // the price of a sweep, so that the charge does not depend on the caches
        m_near.endFreeTick(layer, p_WH);
    } else if (layer.frictional != nullptr) {
        stepWithFriction(p_WH, dt_s, layer, limits, ball, result);
    } else if (layer.fingertip_mm > 0.0) {
        stepBall(p_WH, layer, limits, *ball, nullptr, result);
    } else {
        stepPoint(p_WH, layer, limits, nullptr, true, result);
    }
    return result;
}

/// Step of a god-object that was placed without regard to the surfaces.
[[gnu::noinline]] GodObjectStep GodObject::stepTight(const Vec3& p_WH, double dt_s, const HapticLayer& layer,
                                                     const GodObjectLimits& limits, NearBall* ball) noexcept
{
    if (m_state.placed == GodObjectState::kNotPlaced) {
        restore({});
        m_state.p_WG = p_WH;
        m_state.placed = GodObjectState::kTight;
    }
    TightRoom room;
    TickWork search(kSearch);
    if (layer.fingertip_mm > 0.0) {
        room.search(layer, m_state.p_WG, search);
    }
    if (layer.fingertip_mm == 0.0 || room.isWhole()) {
        // The search is not charged, so that all ticks have the bits of a ball that came from elsewhere.
        m_state.placed = GodObjectState::kPlaced;
        return step(p_WH, dt_s, layer, limits, ball);
    }
    const std::uint32_t searched = std::min(limits.work / kShareOfSearch, kSearch - search.left());
    m_room = &room;
    GodObjectStep result = step(p_WH, dt_s, layer, {limits.iterations, limits.work - searched}, ball);
    m_room = nullptr;
    result.work += searched;
    return result;
}

/// Step in a layer with friction. A god-object held by static friction keeps every bit of its position.
void GodObject::stepWithFriction(const Vec3& p_WH, double dt_s, const HapticLayer& layer, const GodObjectLimits& limits,
                                 NearBall* ball, GodObjectStep& result) noexcept
{
    CoulombFriction friction(layer, dt_s, m_state.slides != 0);
    std::array<HalfSpace, 3> planes;
    ConstrainedPoint point;
    bool isKnown = false; // `planes` and `point` are valid for the end of the tick
    const bool isOn = m_state.constraints > 0 && (m_hasWalked || supports(0, layer));
    if (isOn && m_state.slides == 0) { // sliding contacts most likely keep sliding: no test for holding
        point = withoutFriction(p_WH, layer, planes);
        isKnown = tryHold(point, planes, layer, friction);
    }
    if (isKnown) {
        publish();
        for (std::size_t i = 0; i < m_state.constraints; ++i) {
            m_active[i].n_W = planes[i].n; // the contact normal of a ball differs from the facet normal
        }
    } else if (layer.fingertip_mm > 0.0) {
        stepBall(p_WH, layer, limits, *ball, &friction, result);
    } else {
        stepPoint(p_WH, layer, limits, &friction, isOn, result);
    }
    m_state.slides = m_state.constraints > 0 && friction.slides() ? 1 : 0;
    if (m_state.constraints < 2) {
        return;
    }
    if (!isKnown) {
        point = withoutFriction(p_WH, layer, planes);
    }
    m_push_W.setZero();
    const std::size_t count = std::min(static_cast<std::size_t>(point.count), point.active.size());
    for (std::size_t i = 0; i < count; ++i) {
        m_push_W += point.lambda_mm[i] * planes[point.active[i]].n;
    }
}

/// Constrained point of the current contacts without friction, relative to the current position.
ConstrainedPoint GodObject::withoutFriction(const Vec3& p_WH, const HapticLayer& layer,
                                            std::array<HalfSpace, 3>& planes) const noexcept
{
    double skin_mm = std::numeric_limits<double>::infinity(); // minimum over the contacts
    for (std::size_t i = 0; i < m_state.constraints; ++i) {
        const Facet& facet = m_facets[i];
        skin_mm = std::min(skin_mm, facet.skin_mm);
        if (layer.fingertip_mm > 0.0) {
            BallContact contact;
            contact.facet = facet;
            contact.side = m_state.side[i];
            contact.updateFrom(m_state.p_WG);
            const double radius = radiusOff(m_room, layer, facet.structure, facet.triangle);
            planes[i] = {contact.n, radius + facet.skin_mm - contact.distance_mm};
        } else {
            planes[i] = PointContact{facet, m_state.side[i]}.planeFrom(m_state.p_WG);
        }
    }
    const Vec3 wanted = p_WH - m_state.p_WG;
    if (m_state.constraints == 1) { // closed form for most ticks
        const double lambda = planes[0].offset_mm - planes[0].n.dot(wanted);
        ConstrainedPoint point;
        point.count = lambda > allowance(skin_mm, wanted) ? 1 : 0;
        point.lambda_mm[0] = lambda;
        point.u = point.count == 0 ? wanted : Vec3(wanted + lambda * planes[0].n);
        return point;
    }
    return constrainedPoint(wanted, std::span<const HalfSpace>(planes).first(m_state.constraints),
                            allowance(skin_mm, wanted));
}

/// Returns true if the god-object is on the triangle of the contact. Always true for a ball, because its plane passes
/// through the contact point.
bool GodObject::supports(std::size_t contact, const HapticLayer& layer) const noexcept
{
    return layer.fingertip_mm > 0.0 || PointContact{m_facets[contact], m_state.side[contact]}.supports(m_state.p_WG);
}

/// Returns true if friction holds the god-object on its contacts. In a corner there is no free direction to hold.
/// @param point,planes  result of `withoutFriction`
/// @pre the god-object is on the triangle of the first contact
bool GodObject::tryHold(const ConstrainedPoint& point, const std::array<HalfSpace, 3>& planes, const HapticLayer& layer,
                        CoulombFriction& friction) const noexcept
{
    friction.lift();
    for (std::size_t i = 0; i < static_cast<std::size_t>(point.count); ++i) {
        const std::size_t on = point.active[i];
        if (on > 0 && !supports(on, layer)) {
            return false;
        }
        friction.press(m_facets[on], m_state.p_WG, point.lambda_mm[i]);
    }
    std::array<Vec3, 3> normals;
    for (std::size_t i = 0; i < static_cast<std::size_t>(point.count); ++i) {
        normals[i] = planes[point.active[i]].n;
    }
    const Vec3 slide = freePart(point.u, std::span<const Vec3>(normals).first(static_cast<std::size_t>(point.count)));
    const double r = slide.norm(), rounding = kMinMove * m_facets[0].skin_mm;
    const bool isOn = (point.u - slide).cwiseAbs().maxCoeff() <= kSupporting * m_facets[0].skin_mm;
    return point.count > 0 && isOn && friction.remainingFraction(r, rounding) == 1.0 &&
           (point.count == 1 || r > rounding);
}

/// Reads the facets of a restored state from the surfaces.
PALPATE_ALWAYS_INLINE void GodObject::recallFacets(const HapticLayer& layer) noexcept
{
    for (std::size_t i = 0; i < m_state.constraints && !m_hasFacets; ++i) {
        m_facets[i] = Facet::of(layer.surface(m_state.structure[i]), m_state.structure[i], m_state.triangle[i]);
    }
}

void GodObject::stepBall(const Vec3& p_WH, const HapticLayer& layer, const GodObjectLimits& limits, NearBall& ball,
                         CoulombFriction* friction, GodObjectStep& result) noexcept
{
    TickWork work(limits.work);
    BallTick tick(p_WH, layer, m_room, ball, friction, work, m_state.p_WG);
    for (std::size_t i = 0; i < m_state.constraints; ++i) {
        tick.touch(m_facets[i], m_state.side[i]);
    }
    result.iterations = tick.converge(limits.iterations);
    if (result.iterations >= limits.iterations || work.isSpent()) {
        result.status = TickStatus::IterationLimit;
    }
    // After the status is set: a tick that only lacks work for preparing the next one has converged.
    if (!tick.contacts().isEmpty() && limits.work - work.left() <= kLight) {
        ball.prepare(layer, tick.god(), 2.0 * tick.god() - m_state.p_WG, work);
    }
    result.work = limits.work - work.left();
    m_state.p_WG = tick.god();
    keep(tick.contacts());
    publish();
    for (std::size_t i = 0; i < m_state.constraints; ++i) {
        m_active[i].n_W =
            tick.contacts()[i].n; // towards the contact point; differs from the facet normal on edges and corners
    }
}

PALPATE_ALWAYS_INLINE void GodObject::stepPoint(const Vec3& p_WH, const HapticLayer& layer,
                                                const GodObjectLimits& limits, CoulombFriction* friction, bool mayWalk,
                                                GodObjectStep& result) noexcept
{
    m_near.beginTick(TickWork(limits.work));
    const Before before{m_state.p_WG, m_state.side, m_state.constraints};
    Walk::Ended ended = Walk::Ended::Unfinished;
    bool isClear = false;
    const bool isInCrease =
        m_state.constraints == 2 && m_state.structure[0] == m_state.structure[1] && m_state.side[0] == m_state.side[1];
    if ((m_state.constraints == 1 || isInCrease) && mayWalk) {
        // Most ticks only slide over the surface, which the walk does without a general sweep.
        Walk walk(p_WH, layer, m_near, friction, {m_state.p_WG, m_facets[0], m_facets[1], m_state.side[0]});
        ended = walk.run(isInCrease    ? Walk::Start::InCrease
                         : m_hasWalked ? Walk::Start::WellInside
                                       : Walk::Start::OnFacet,
                         limits.iterations);
        result.iterations = walk.moves();
        isClear = walk.isClear();
        m_state.constraints = 1;
        if (Walk::isHeldByTwo(ended)) {
            m_state.side[1] = m_state.side[0];
            m_state.constraints = 2;
        }
    }
    if (!Walk::hasArrived(ended)) {
        PointTick tick(p_WH, layer, m_near, friction, m_state.p_WG, result.iterations);
        for (std::size_t i = 0; i < m_state.constraints; ++i) {
            tick.touch(m_facets[i], m_state.side[i]);
        }
        result.iterations = tick.converge(limits.iterations);
        if (result.iterations >= limits.iterations || m_near.work().isSpent()) {
            result.status = TickStatus::IterationLimit;
        }
        // Where many planes meet at shallow angles, keeping the skin distance to all of them can increase the distance
        // to the HIP. The god-object then keeps its position.
        const double most = (p_WH - m_state.p_WG).norm() + kTouchRadius * layer.skin_mm;
        if (m_state.constraints == 0 || (p_WH - tick.god()).norm() <= most) {
            m_state.p_WG = tick.god();
            keep(tick.contacts());
        }
    }
    result.work = limits.work - m_near.work().left();
    if (ended != Walk::Ended::OnFacet && friction == nullptr) {
        keepHeld(p_WH, layer, before);
    }
    publish();
    // After a walk the god-object is one skin above the facet, unless friction held it where it was.
    m_hasWalked = ended == Walk::Ended::OnFacet && (friction == nullptr || friction->lastSlid());
    lookAhead(layer, isClear && Walk::hasArrived(ended));
}

/// Keeps the contacts of the previous tick if they still constrain the god-object to the same position. At an edge or a
/// corner several sets of facets give the same position; without this rule a hand at rest would alternate between
/// triangles, and forces that depend on the triangle with it.
void GodObject::keepHeld(const Vec3& p_WH, const HapticLayer& layer, const Before& before) noexcept
{
    if (before.constraints == 0 || m_state.constraints == 0) {
        return;
    }
    const double skin_mm = m_facets[0].skin_mm;
    if (!((m_state.p_WG - before.p_WG).cwiseAbs().maxCoeff() <= kSupporting * skin_mm)) {
        return;
    }
    const Before now{m_state.p_WG, m_state.side, m_state.constraints};
    const std::array<Facet, 3> facets = m_facets;
    m_state.p_WG = before.p_WG;
    m_state.side = before.side;
    m_state.constraints = before.constraints;
    for (std::size_t i = 0; i < m_state.constraints; ++i) {
        m_facets[i] = Facet::of(layer.surface(m_state.structure[i]), m_state.structure[i], m_state.triangle[i]);
    }
    std::array<HalfSpace, 3> planes;
    const ConstrainedPoint point = withoutFriction(p_WH, layer, planes);
    if (point.count != m_state.constraints || !(point.u.cwiseAbs().maxCoeff() <= kPlaneTolerance * skin_mm)) {
        m_state.p_WG = now.p_WG;
        m_state.side = now.side;
        m_state.constraints = now.constraints;
        m_facets = facets;
    }
}

/// Stores at most three contacts in the state.
template<class Contacts>
void GodObject::keep(const Contacts& contacts) noexcept
{
    m_state.constraints = static_cast<std::uint8_t>(std::min<std::size_t>(contacts.count(), m_facets.size()));
    for (std::size_t i = 0; i < m_state.constraints; ++i) {
        m_facets[i] = contacts[i].facet;
        m_state.side[i] = static_cast<std::int8_t>(contacts[i].side);
    }
}

/// Sets `m_active` and the triangle numbers of the state from the facets.
PALPATE_ALWAYS_INLINE void GodObject::publish() noexcept
{
    for (std::size_t i = 0; i < m_state.constraints; ++i) {
        const Facet& facet = m_facets[i];
        m_active[i] = {facet.structure, facet.triangle, m_state.side[i] * facet.n};
        m_state.structure[i] = facet.structure;
        m_state.triangle[i] = facet.triangle;
    }
    m_hasFacets = true;
}

/// Prefetches part of the facets that the following ticks will need.
PALPATE_ALWAYS_INLINE void GodObject::lookAhead(const HapticLayer& layer, bool hasWalkedClear) noexcept
{
    if (hasWalkedClear) {
        const geometry::SurfaceIndex& surface = layer.surface(m_facets[0].structure);
        m_near.endClearTick(layer, m_state.p_WG, surface.isClearAround(m_facets[0].triangle));
        surface.prefetchNeighbours(m_facets[0].triangle);
    } else if (m_state.constraints == 0) {
        m_near.endFreeTick(layer, m_state.p_WG);
    } else {
        m_near.endTick(layer, m_state.p_WG);
    }
}

void GodObject::forgetContacts() noexcept
{
    m_state.constraints = 0;
    m_hasFacets = false;
    m_hasWalked = false;
    m_near.clear();
}

void GodObject::restore(const GodObjectState& state) noexcept
{
    forgetContacts();
    m_state = state;
}

} // namespace palpate::haptics::internal
