// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/haptics/GodObject.h"

#include "palpate/haptics/internal/ConstrainedPoint.h"
#include "palpate/haptics/internal/Fan.h"
#include "palpate/haptics/internal/SurfaceWalk.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace palpate::haptics {

namespace {

using internal::ConstrainedPoint;
using internal::Crossing;
using internal::Facet;
using internal::Foot;
using internal::HalfSpace;
using internal::kTouched;
using internal::Neighbourhood;
using internal::Sweep;

/// A facet that the god-object touches, and from which side.
struct Contact
{
    Facet facet;
    int side;
    Foot foot = Foot::Away;  ///< where the god-object stands on it, when it was last asked
    bool isInTheWay = false; ///< was met by a move from the very place where the god-object is

    [[nodiscard]] Vec3 normal() const noexcept { return side > 0 ? facet.n : Vec3(-facet.n); }
    /// Distance of `g` in front of the plane [mm].
    [[nodiscard]] double gap(const Vec3& g) const noexcept { return side * facet.n.dot(g - facet.a); }
    [[nodiscard]] bool isSame(const Contact& other) const noexcept
    {
        return facet.structure == other.facet.structure && facet.triangle == other.facet.triangle && side == other.side;
    }
};

/// One tick of one god-object.
class Tick
{
  public:
    /// @param walked  moves made before
    Tick(const Vec3& hip, const HapticScene& scene, const HapticLayer& layer, Neighbourhood& near, const Vec3& god,
         std::uint32_t walked) noexcept
        : m_hip(hip)
        , m_scene(scene)
        , m_layer(layer)
        , m_near(near)
        , m_god(god)
        , m_walked(walked)
    {
    }

    void touch(const Facet& facet, int side, bool isInTheWay = false) noexcept
    {
        m_contacts[static_cast<std::size_t>(m_count++)] = {facet, side, Foot::Away, isInTheWay};
        m_mayWalk = isInTheWay; // from a facet that is newly met
        m_skin_mm = std::max(m_skin_mm, facet.skin_mm);
    }

    /// @return how many moves were tried, `limit` when it was not enough.
    std::uint32_t converge(std::uint32_t limit) noexcept
    {
        const std::uint32_t moves = moveUntilDone(limit);
        if (m_count == 0 && m_lastMet && (m_hip - m_god).cwiseAbs().maxCoeff() > m_lastMet->facet.skin_mm) {
            // What stood in the way last: no god-object is held by nothing.
            m_contacts[0] = *m_lastMet;
            m_count = 1;
        }
        return moves;
    }

    [[nodiscard]] const Vec3& god() const noexcept { return m_god; }
    [[nodiscard]] int count() const noexcept { return m_count; }
    [[nodiscard]] const Contact& contact(int i) const noexcept { return m_contacts[static_cast<std::size_t>(i)]; }

  private:
    std::uint32_t moveUntilDone(std::uint32_t limit) noexcept
    {
        double spring = std::numeric_limits<double>::infinity();
        std::uint32_t i = 0;
        for (; i + m_walked < limit && !m_near.work().isSpent(); ++i) {
            if (i % kPatience == kPatience - 1) {
                // Planes that repeat each other to rounding can take turns for ever: what gains less than a skin in so
                // many moves has arrived.
                const double last = std::exchange(spring, (m_hip - m_god).norm());
                if (spring > last - m_skin_mm && !escape()) {
                    return i + 1 + m_walked;
                }
            }
            if (m_count == 1 && m_mayWalk && hasWalkedHome(limit - i - m_walked)) {
                return i + m_walked;
            }
            if (i + m_walked >= limit || m_near.work().isSpent()) {
                break;
            }
            const Vec3 target = nextTarget();
            Crossing crossing;
            const Sweep swept = m_near.sweep(m_scene, m_layer, m_god, target, crossing);
            if (swept != Sweep::Free) {
                m_lastMet = {crossing.facet, crossing.side};
            }
            if (swept == Sweep::Unknown) {
                break;
            }
            if (swept == Sweep::Blocked) {
                const bool isOnEdge = m_count == 0 && turnsRound();
                if ((!stopAt(target, crossing) || isOnEdge) && !escape()) {
                    return i + 1 + m_walked;
                }
                continue;
            }
            moveTo(target);
            const int before = m_count;
            keepSupporting();
            if (m_count == before && (isCertain() || !escape())) {
                return i + 1 + m_walked;
            }
        }
        return i + m_walked;
    }

    /// From one facet over to the next, as long as that is all there is to do. @return true when nothing is left.
    bool hasWalkedHome(std::uint32_t most) noexcept
    {
        Contact& c = m_contacts[0];
        const internal::SurfaceWalk walk =
            internal::walk(m_scene, m_layer, m_near, m_hip, most, c.side, false, nullptr, m_god, c.facet);
        m_walked += walk.moves;
        if (walk.isInCrease) {
            touch(walk.beyond, c.side);
        }
        m_mayWalk = false; // again from the next facet that is met
        return walk.hasArrived;
    }

    /// Where the HIP is nearest to a convex edge, each facet at it leads just beyond the edge and lets go there, and
    /// the other is met by the straight way.
    /// @return true when that has come round a few times without gaining a skin.
    bool turnsRound() noexcept
    {
        const double spring = (m_hip - m_god).norm();
        if (spring < m_letGo_mm - m_skin_mm) {
            m_letGo_mm = spring;
            m_rounds = 0;
            return false;
        }
        return ++m_rounds >= kRounds;
    }

    /// The constrained point of the present contacts; those with no part in it are released.
    Vec3 nextTarget() noexcept
    {
        if (m_count == 0) {
            return m_hip;
        }
        const Vec3 wanted = m_hip - m_god;
        std::array<HalfSpace, kMost> planes;
        for (std::size_t i = 0; i < static_cast<std::size_t>(m_count); ++i) {
            planes[i] = {m_contacts[i].normal(), m_contacts[i].facet.skin_mm - m_contacts[i].gap(m_god)};
        }
        const ConstrainedPoint point = internal::constrainedPoint(
            wanted, std::span(planes).first(static_cast<std::size_t>(m_count)), internal::allowance(m_skin_mm, wanted));
        for (int i = 0; i < point.count; ++i) {
            // `active` ascends, so nothing is overwritten before it is used.
            const std::size_t kept = point.active[static_cast<std::size_t>(i)];
            if (kept != static_cast<std::size_t>(i)) {
                m_contacts[static_cast<std::size_t>(i)] = m_contacts[kept];
            }
        }
        m_count = point.count;
        return m_god + point.u;
    }

    /// Moves up to the facet in the way and takes its plane as a constraint.
    /// @return false when that leads nowhere any more.
    bool stopAt(const Vec3& target, const Crossing& crossing) noexcept
    {
        const Contact met{crossing.facet, crossing.side};
        m_skin_mm = std::max(m_skin_mm, met.facet.skin_mm);
        if (moveTo(m_god + crossing.stop * (target - m_god))) {
            keepSupporting();
        }
        // In place each new plane moves the constrained point away from the HIP, as in a dual active-set method: no set
        // of planes comes back.
        const bool isHeld = std::any_of(m_contacts.begin(), m_contacts.begin() + m_count,
                                        [&met](const Contact& c) { return c.isSame(met); });
        if (isHeld) {
            return false;
        }
        if (m_count == kMost) {
            std::move(m_contacts.begin() + 1, m_contacts.end(), m_contacts.begin());
            --m_count;
        }
        touch(met.facet, met.side, true);
        return true;
    }

    /// @return false, unmoved, for less than rounding: a thousandth of the skin.
    bool moveTo(const Vec3& p) noexcept
    {
        const double most = (p - m_god).cwiseAbs().maxCoeff();
        if (most <= 1e-3 * m_skin_mm) {
            return false;
        }
        m_god = p;
        // Within a skin it is the same place: planes that are one to rounding are that far apart.
        for (int i = 0; i < m_count && most > m_skin_mm; ++i) {
            m_contacts[static_cast<std::size_t>(i)].isInTheWay = false;
        }
        return true;
    }

    /// Drops the contacts whose triangle is no longer below the god-object, unless it stood in the way of a move from
    /// here: with others it may lie beside, met at a shallow angle; alone its foot is on its very edge, and what blocks
    /// is not let go of.
    void keepSupporting() noexcept
    {
        // With several contacts the foot on one may lie at its very edge, where rounding must not decide.
        const double slack = m_count > 1 ? m_skin_mm : 0.0;
        const auto end = std::remove_if(m_contacts.begin(), m_contacts.begin() + m_count, [&](Contact& c) {
            const double plate = c.facet.isTwoSided ? internal::kPlate * c.facet.skin_mm : 0.0;
            c.foot = internal::footOn(c.facet, c.side, m_god, 2.0 * c.facet.skin_mm, std::max(slack, plate),
                                      kTouched * c.facet.skin_mm);
            return c.foot == Foot::Away && !c.isInTheWay;
        });
        m_count = static_cast<int>(end - m_contacts.begin());
    }

    /// True when the contacts alone show that no move comes closer: none, one with the foot well inside it, or two
    /// below the god-object that share an edge and rise towards each other.
    [[nodiscard]] bool isCertain() const noexcept
    {
        return m_count == 0 || (m_count == 1 && m_contacts[0].foot == Foot::Inside) ||
               (m_count == 2 && isConcaveEdge());
    }

    [[nodiscard]] bool isConcaveEdge() const noexcept
    {
        const Contact &p = m_contacts[0], &q = m_contacts[1];
        if (p.foot == Foot::Away || q.foot == Foot::Away) {
            return false;
        }
        int shared = 0;
        for (const Vec3* v : {&p.facet.a, &p.facet.b, &p.facet.c}) {
            if (*v == q.facet.a || *v == q.facet.b || *v == q.facet.c) {
                ++shared;
            } else if (q.gap(*v) < 0.0) {
                return false;
            }
        }
        return shared == 2;
    }

    /// At a vertex the surface may fall away on one side although the planes around it leave no room: the free space
    /// is not the intersection of the half-spaces there. Tries the straight way and those along each facet and each
    /// pair of facets that are touched.
    /// @return true when one of them led closer to the HIP.
    bool escape() noexcept
    {
        // Held contacts first: they lead on more often.
        std::array<Facet, kMostTouched> touched;
        std::array<int, kMostTouched> side{};
        std::size_t n = 0;
        double skin = m_skin_mm;
        for (int i = 0; i < m_count; ++i) {
            const Contact& c = m_contacts[static_cast<std::size_t>(i)];
            touched[n] = c.facet;
            side[n++] = c.side;
        }
        const std::size_t held = n;
        // Feet may lie a reach beside a facet.
        bool isRoom = true;
        const bool isKnown = m_near.forEachNear(
            m_scene, m_layer, m_god, Neighbourhood::kNearby * m_layer.skin_mm, [&](const Facet& facet) {
                const int s = facet.n.dot(m_god - facet.a) < 0.0 && facet.isTwoSided ? -1 : 1;
                const double reach = kTouched * facet.skin_mm;
                if (internal::footOn(facet, s, m_god, reach, reach, 0.0) == Foot::Away) {
                    return;
                }
                for (std::size_t i = 0; i < held; ++i) {
                    if (touched[i].structure == facet.structure && touched[i].triangle == facet.triangle &&
                        side[i] == s) {
                        return;
                    }
                }
                if (n == touched.size()) {
                    isRoom = false;
                    return;
                }
                touched[n] = facet;
                side[n++] = s;
                skin = std::max(skin, facet.skin_mm);
            });
        // Within the skin's thickness a facet's very edge may stand in the way of what is open beyond it: the ways are
        // tried from a little above, away from the HIP.
        const Vec3 wanted = m_hip - m_god;
        const double spring = wanted.norm();
        const double enough = spring - 16.0 * skin; // less gain is not worth a move
        Vec3 from = m_god - wanted * (kTouched * skin / spring);
        if (isKnown && isRoom && enough > 0.0 &&
            internal::isHeldByFan(std::span<const Facet>(touched).first(n), from, m_hip - from, enough)) {
            return false;
        }
        Crossing above;
        const Sweep swept = m_near.sweep(m_scene, m_layer, m_god, from, above);
        if (swept == Sweep::Unknown) {
            return false;
        }
        if (swept == Sweep::Blocked) {
            from = m_god + above.stop * (from - m_god);
        }
        if (follow(from, {}, enough)) {
            return true;
        }
        for (std::size_t i = 0; i < n; ++i) {
            if (follow(from, std::array{Contact{touched[i], side[i]}}, enough)) {
                return true;
            }
        }
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = i + 1; j < n; ++j) {
                if (follow(from, std::array{Contact{touched[i], side[i]}, Contact{touched[j], side[j]}}, enough)) {
                    return true;
                }
            }
        }
        return false;
    }

    /// Moves from `from` along the given planes alone. @return false, unmoved, when that leads no nearer to the HIP
    /// than `enough` [mm].
    bool follow(Vec3 from, std::span<const Contact> along, double enough) noexcept
    {
        std::array<HalfSpace, 2> planes;
        const auto setPlanes = [&] {
            for (std::size_t i = 0; i < along.size(); ++i) {
                planes[i] = {along[i].normal(), along[i].facet.skin_mm - along[i].gap(from)};
            }
            return std::span<const HalfSpace>(planes).first(along.size());
        };
        const Vec3 pull = m_hip - from;
        if ((pull - internal::constrainedPoint(pull, setPlanes(), internal::allowance(m_skin_mm, pull)).u).norm() >
            enough) {
            return false; // as most: nothing needs to be asked
        }
        // First up to a skin above the planes themselves, where that is free: their edges are no longer in the way
        // then.
        Crossing crossing;
        const Vec3 up = internal::constrainedPoint(Vec3::Zero(), setPlanes(), 0.0).u;
        if (!along.empty() && m_near.sweep(m_scene, m_layer, from, from + up, crossing) == Sweep::Free) {
            from += up;
        }
        const Vec3 wanted = m_hip - from;
        const ConstrainedPoint point =
            internal::constrainedPoint(wanted, setPlanes(), internal::allowance(m_skin_mm, wanted));
        if ((wanted - point.u).norm() > enough) {
            return false;
        }
        Vec3 u = point.u;
        const Sweep swept = m_near.sweep(m_scene, m_layer, from, from + u, crossing);
        const bool isBlocked = swept == Sweep::Blocked;
        if (swept == Sweep::Unknown) {
            return false;
        }
        if (isBlocked) {
            u *= crossing.stop;
            if ((wanted - u).norm() > enough) {
                return false;
            }
        }
        moveTo(from + u);
        m_count = 0;
        for (int i = 0; i < point.count; ++i) {
            const Contact& c = along[point.active[static_cast<std::size_t>(i)]];
            touch(c.facet, c.side);
        }
        keepSupporting();
        if (isBlocked) {
            touch(crossing.facet, crossing.side);
        }
        return true;
    }

    static constexpr std::size_t kMost = 4;         // three constraints and the plane just met
    static constexpr std::size_t kMostTouched = 16; // facets around a vertex that `escape` considers
    static constexpr std::uint32_t kPatience = 32;
    static constexpr int kRounds = 3;

    const Vec3& m_hip;
    const HapticScene& m_scene;
    const HapticLayer& m_layer;
    Neighbourhood& m_near;
    Vec3 m_god;
    std::array<Contact, kMost> m_contacts;
    int m_count = 0;
    bool m_mayWalk = false;
    std::uint32_t m_walked; ///< moves made by walking
    double m_skin_mm = 0.0;
    double m_letGo_mm = std::numeric_limits<double>::infinity(); ///< distance to the HIP when nothing held it last
    int m_rounds = 0;                                            ///< in which that fell by less than a skin
    std::optional<Contact> m_lastMet;                            ///< the last facet in the way
};

} // namespace

GodObjectStep GodObject::step(const Vec3& p_WH, const HapticScene& scene, std::size_t layerNumber,
                              const GodObjectLimits& limits) noexcept
{
    GodObjectStep result;
    if (!scene.reaches(p_WH)) {
        result.p_WG = m_state.p_WG;
        result.status = TickStatus::InvalidInput;
        return result;
    }
    if (m_state.placed == 0) {
        m_state = {};
        m_state.p_WG = p_WH;
        m_state.placed = 1;
        clearCaches();
    }
    const HapticLayer& layer = scene.layer(layerNumber);
    for (std::size_t i = 0; i < m_state.constraints && !m_hasFacets; ++i) {
        const geometry::SurfaceIndex& surface = *scene.structures()[m_state.structure[i]].surface;
        m_facets[i] = Facet::of(surface, m_state.structure[i], m_state.triangle[i]);
    }
    internal::TickWork work(limits.work);
    if (scene.fingertip_mm() > 0.0) {
        run(internal::BallTick(p_WH, scene, layer, m_ballNeighbourhood, work, m_state.p_WG), limits, result);
        if (work.isSpent()) {
            result.status = TickStatus::IterationLimit;
        }
    } else if (m_state.constraints == 0 && m_neighbourhood.isFree(m_state.p_WG, p_WH)) {
        m_state.p_WG = result.p_WG = p_WH;
        result.iterations = 1;
        m_neighbourhood.endFreeTick(scene, layer, p_WH);
    } else {
        m_neighbourhood.beginTick(work);
        // Most ticks: all there is to do is to walk on over the surface.
        internal::SurfaceWalk walk;
        const bool isInCrease = m_state.constraints == 2 && m_state.structure[0] == m_state.structure[1] &&
                                m_state.side[0] == m_state.side[1];
        if (m_state.constraints == 1 || isInCrease) {
            walk = internal::walk(scene, layer, m_neighbourhood, p_WH, limits.iterations, m_state.side[0], m_hasWalked,
                                  isInCrease ? &m_facets[1] : nullptr, m_state.p_WG, m_facets[0]);
            if (walk.isInCrease) {
                m_facets[1] = walk.beyond;
                m_state.side[1] = m_state.side[0];
            }
            m_state.constraints = walk.isInCrease ? 2 : 1;
        }
        if (walk.hasArrived) {
            result.p_WG = m_state.p_WG;
            result.constraints = m_state.constraints;
            result.iterations = walk.moves;
            for (std::size_t i = 0; i < m_state.constraints; ++i) {
                const Facet& facet = m_facets[i];
                result.active[i] = {facet.structure, facet.triangle, m_state.side[i] * facet.n};
                m_state.structure[i] = facet.structure;
                m_state.triangle[i] = facet.triangle;
            }
            m_hasFacets = true;
        } else {
            run(Tick(p_WH, scene, layer, m_neighbourhood, m_state.p_WG, walk.moves), limits, result);
            if (m_neighbourhood.work().isSpent()) {
                result.status = TickStatus::IterationLimit;
            }
        }
        m_hasWalked = walk.hasArrived && !walk.isInCrease;
        if (walk.hasArrived && walk.isClear) {
            const geometry::SurfaceIndex& surface = *scene.structures()[m_facets[0].structure].surface;
            m_neighbourhood.endClearTick(scene, layer, m_state.p_WG, surface.isClearAround(m_facets[0].triangle));
            surface.prefetchNeighbours(m_facets[0].triangle);
        } else if (m_state.constraints == 0) {
            m_neighbourhood.endFreeTick(scene, layer, m_state.p_WG);
        } else {
            m_neighbourhood.endTick(scene, layer, m_state.p_WG);
        }
    }
    return result;
}

template<class AnyTick>
void GodObject::run(AnyTick tick, const GodObjectLimits& limits, GodObjectStep& result) noexcept
{
    for (std::size_t i = 0; i < m_state.constraints; ++i) {
        tick.touch(m_facets[i], m_state.side[i]);
    }
    result.iterations = tick.converge(limits.iterations);
    if (result.iterations >= limits.iterations) {
        result.status = TickStatus::IterationLimit;
    }
    m_state.p_WG = result.p_WG = tick.god();
    result.constraints = m_state.constraints = static_cast<std::uint8_t>(std::min(tick.count(), 3));
    for (int i = 0; i < m_state.constraints; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const auto& contact = tick.contact(i);
        result.active[k] = {contact.facet.structure, contact.facet.triangle, contact.normal()};
        m_state.structure[k] = contact.facet.structure;
        m_state.triangle[k] = contact.facet.triangle;
        m_state.side[k] = static_cast<std::int8_t>(contact.side);
        m_facets[k] = contact.facet;
    }
    m_hasFacets = true;
}

void GodObject::clearCaches() noexcept
{
    m_hasFacets = false;
    m_hasWalked = false;
    m_neighbourhood.clear();
    m_ballNeighbourhood.clear();
}

void GodObject::forgetContacts() noexcept
{
    m_state.constraints = 0;
    clearCaches();
}

void GodObject::restore(const GodObjectState& state) noexcept
{
    m_state = state;
    clearCaches();
}

} // namespace palpate::haptics
