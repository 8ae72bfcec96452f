// SPDX-License-Identifier: BSD-3-Clause
#include "MovingGame.h"

#include "FaultLog.h"
#include "LayerJudge.h"
#include "MovedNodes.h"
#include "MovingHand.h"
#include "SameBits.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace palpate::adversary {

namespace {

using haptics::Palpator;
using haptics::TickResult;
using haptics::TickStatus;

/// Probabilities per tick.
struct Odds
{
    static constexpr double rest = 0.01;   ///< check the rest position
    static constexpr double derive = 0.02; ///< compare the force with derivatives
    static constexpr double nodes = 0.01;  ///< move the nodes of the surfaces
    static constexpr double restore = 1e-3;
    static constexpr double hide = 3e-3; ///< hide or show a group
    static constexpr double clock = 3e-3;
    static constexpr double reset = 2e-4;
    static constexpr double bad = 5e-4; ///< input
};
constexpr double kInverse_mm = geometry::SurfaceMotion::kInverse_mm;

/// A group of structures in its rest shape, in a scene of its own without motion.
struct GroupAtRest
{
    std::array<std::unique_ptr<haptics::HapticScene>, 2> scenes; ///< equal: a change of the scene is one here as well
    Palpator palpator;
    std::unique_ptr<LayerJudge> judge;
    std::unique_ptr<MovedNodes> nodes;
    Vec3 god = Vec3::Zero(), force = Vec3::Zero(); ///< in the world in the previous tick [mm, N]
    bool isPlain = true;                           ///< linear springs without damping, friction and maps
    bool isDragged = false;
    bool isReturning = false; ///< shown since the last tick
    double stiffest = 0.0;    ///< of plain springs [N/mm]
    double mostDamping = 0.0;
    double skin_mm = 0.0;
};

/// The contacts of one layer in a tick.
struct OfLayer
{
    Vec3 force = Vec3::Zero(), god = Vec3::Zero();
    int count = 0;
};

OfLayer ofLayer(const TickResult& tick, std::size_t layer)
{
    OfLayer sum;
    for (std::size_t c = 0; c < tick.contactCount; ++c) {
        if (tick.contacts[c].layer == layer) {
            sum.force += tick.contacts[c].f_W;
            sum.god = tick.contacts[c].p_WG;
            ++sum.count;
        }
    }
    return sum;
}

class MovingGame
{
  public:
    MovingGame(std::uint64_t seed, Tally& tally)
        : m_tally(tally)
        , m_log(Family::Moving, seed, tally)
        , m_chance(firstOf(Family::Moving, seed))
        , m_scene(m_chance)
        , m_isExact(m_chance.is(0.5))
        , m_hand(m_scene, m_isExact, m_chance)
        , m_dt_s(m_chance.is(0.7) ? 1e-3 : m_chance.magnitude(1e-4, 4e-3))
        , m_groups(m_scene.groups.size())
        , m_shown((1u << m_scene.groups.size()) - 1)
    {
        for (std::uint32_t g = 0; g < m_groups.size(); ++g) {
            GroupAtRest& group = m_groups[g];
            for (auto& scene : group.scenes) {
                scene = m_scene.rest.build(1u << g);
            }
            group.judge = std::make_unique<LayerJudge>(m_scene.rest, g, m_chance.bits());
            const JudgedLayer layer(m_scene.rest, g);
            group.nodes = std::make_unique<MovedNodes>(layer, motionOf(g));
            group.skin_mm = layer.skin_mm;
            for (const RandomStructure& one : m_scene.rest.structures) {
                if (one.layer == g) {
                    const haptics::HapticStructure structure = one.structure();
                    group.isPlain = group.isPlain && structure.isPlain() && !structure.isDamped();
                    group.isDragged = group.isDragged || one.tissue.friction_drag_Ns_per_mm > 0.0;
                    group.stiffest = std::max(group.stiffest, one.tissue.stiffness_N_per_mm);
                    group.mostDamping = std::max(
                        {group.mostDamping, one.tissue.damping_Ns_per_mm, one.maps.damping.isEmpty() ? 0.0 : 1e-2});
                }
            }
        }
        setScene();
    }

    void tick(std::int64_t number)
    {
        m_number = number;
        m_t = double(number) * m_dt_s;
        if (m_chance.is(Odds::reset)) {
            reset();
        }
        if (m_groups.size() > 1 && number > 0 && m_chance.is(Odds::hide)) {
            switchGroup();
        }
        if (number > 0 && m_chance.is(Odds::clock)) {
            changeClocks();
        }
        const Vec3 hip = m_hand.next(m_t);
        if (m_chance.is(Odds::bad)) {
            bad(hip);
            return;
        }
        if (m_compared == 0 && m_chance.is(Odds::restore)) {
            m_twin.borrowScene(m_whole.scene());
            m_twin.restore(m_whole.state());
            m_compared = m_chance.whole(5, 60);
            ++m_tally.restores;
        }
        step(hip);
    }

    void finish()
    {
        for (const GroupAtRest& group : m_groups) {
            m_tally.sheetTicks += group.judge->sheetTicks();
            m_tally.restTicks += group.judge->restTicks();
            m_tally.energyTicks += group.judge->energyTicks();
            m_tally.nodeTicks += group.nodes->ticks();
        }
        m_tally.failedSeeds += m_log.isEmpty() ? 0 : 1;
    }

  private:
    [[nodiscard]] RandomMotion* motionOf(std::size_t group)
    {
        std::optional<RandomMotion>& motion = m_scene.groups[group].motion;
        return motion ? &*motion : nullptr;
    }
    [[nodiscard]] bool isShown(std::size_t group) const { return (m_shown >> group & 1u) != 0; }

    void setScene()
    {
        std::unique_ptr<haptics::HapticScene> next = m_scene.build(m_shown);
        m_whole.borrowScene(next.get());
        m_twin.borrowScene(nullptr);
        m_sceneNow = std::move(next);
        m_compared = 0;
        m_stillTicks = 0;
        m_sceneNumber = 1 - m_sceneNumber;
        for (std::uint32_t g = 0; g < m_groups.size(); ++g) {
            m_groups[g].palpator.borrowScene(isShown(g) ? m_groups[g].scenes[m_sceneNumber].get() : nullptr);
        }
    }

    void reset()
    {
        m_whole.reset();
        m_compared = 0;
        m_stillTicks = 0;
        m_hasStarted = false;
        for (GroupAtRest& group : m_groups) {
            group.palpator.reset();
            forget(group);
        }
    }

    static void forget(GroupAtRest& group)
    {
        group.judge->forget();
        group.nodes->forget();
    }

    void switchGroup()
    {
        const auto g = static_cast<std::uint32_t>(m_chance.below(m_groups.size()));
        m_shown ^= 1u << g;
        ++m_tally.switches;
        setScene();
        forget(m_groups[g]);
        if (isShown(
                g)) { // whether a contact is resumed depends on the time hidden, and of moving tissue on its next tick
            m_groups[g].isReturning = motionOf(g) != nullptr;
            const auto layer = static_cast<std::size_t>(std::popcount(m_shown & ((1u << g) - 1)));
            haptics::PalpatorState state = m_whole.state();
            state.layers[0] = state.layers[layer];
            state.left = {};
            m_groups[g].palpator.restore(state);
        }
    }

    /// Holds or plays the motions at another rate, and may set another amplitude. The hand may rest meanwhile.
    void changeClocks()
    {
        constexpr std::array kRates{0.0, 0.0, 0.5, 1.0, 2.0, -1.0};
        const double rate = kRates[m_chance.below(kRates.size())];
        const bool isOther = m_chance.is(0.2);
        for (std::size_t g = 0; g < m_groups.size(); ++g) {
            if (RandomMotion* const motion = motionOf(g)) {
                const double amplitude = isOther ? m_chance.share() : motion->amplitude();
                motion->setClock(m_t, motion->phase_s(m_t), rate, amplitude);
            }
        }
        m_isHeld = rate == 0.0;
        if (m_chance.is(0.5)) {
            m_hand.rest(m_chance.whole(20, 200));
        }
        setScene();
        // A surface that is set to another amplitude has not passed through what lies between.
        for (GroupAtRest& group : m_groups) {
            group.nodes->forget();
        }
    }

    void bad(Vec3 hip)
    {
        hip[m_chance.whole(0, 2)] =
            m_chance.is(0.5) ? std::numeric_limits<double>::quiet_NaN() : -std::numeric_limits<double>::infinity();
        const haptics::PalpatorState before = m_whole.state();
        const TickResult tick = m_whole.step(hip, m_dt_s, nullptr, m_t);
        const haptics::PalpatorState after = m_whole.state();
        bool isSame = tick.f_W.isZero(0.0) && tick.status == TickStatus::InvalidInput &&
                      m_whole.tissuePower_mW() == 0.0 && sameBits(before.p_WH, after.p_WH);
        for (std::size_t i = 0; i < before.layers.size(); ++i) {
            isSame = isSame && sameBits(before.layers[i].p_WG, after.layers[i].p_WG) &&
                     sameBits(before.p_RH[i], after.p_RH[i]);
        }
        if (m_compared > 0) {
            (void)m_twin.step(hip, m_dt_s, nullptr, m_t);
        }
        if (!isSame) {
            say({"bad input moved or pushed something", 0.0, "", Vec3::Zero(), Vec3::Zero()});
        }
    }

    void step(const Vec3& hip)
    {
        m_isStill = m_hasStarted && hip == m_hip;
        m_rounding_mm = 32.0 * std::numeric_limits<double>::epsilon() *
                        (hip.cwiseAbs().maxCoeff() + m_scene.rest.bounds.min().cwiseAbs().maxCoeff() +
                         m_scene.rest.bounds.max().cwiseAbs().maxCoeff());
        m_v = m_hasStarted ? Vec3((hip - m_hip) / m_dt_s) : Vec3::Zero();
        m_hip = hip;
        const TickResult whole = m_whole.step(hip, m_dt_s, nullptr, m_t);
        const haptics::PalpatorState state = m_whole.state();
        ++m_tally.ticks;
        m_tally.inContact += whole.constraints > 0 ? 1 : 0;
        m_tally.atBound += whole.status == TickStatus::IterationLimit ? 1 : 0;
        m_stillTicks = m_isStill && m_isHeld ? m_stillTicks + 1 : 0;
        m_isAtBound = whole.status == TickStatus::IterationLimit;
        m_power_mW = m_powerSlack_mW = 0.0;
        Faults faults;
        if (whole.status == TickStatus::InvalidInput) {
            faults.push_back({"refused a HIP that is not far away", 0.0, "", Vec3::Zero(), hip});
        } else {
            m_isPowerKnown = true;
            std::size_t layer = 0;
            for (std::size_t g = 0; g < m_groups.size(); ++g) {
                if (isShown(g)) {
                    judgeGroup(g, layer, whole, state, faults);
                    ++layer;
                }
            }
            const double power = m_whole.tissuePower_mW();
            if (m_isPowerKnown && !(std::abs(power - m_power_mW) <= m_powerSlack_mW)) {
                faults.push_back({"power of the tissue", power - m_power_mW, "mW", Vec3::Zero(), Vec3::Zero()});
            }
        }
        compareTwin(whole, faults);
        m_hasStarted = true;
        if (m_number >= m_tally.printedFrom && m_number <= m_tally.printedTo) {
            print(whole);
        }
        for (const Fault& fault : faults) {
            say(fault);
        }
    }

    void compareTwin(const TickResult& whole, Faults& faults)
    {
        if (m_compared == 0) {
            return;
        }
        --m_compared;
        if (!sameBits(whole, m_twin.step(m_hip, m_dt_s, nullptr, m_t))) {
            m_compared = 0;
            faults.push_back({"restored: other bits", 0.0, "", whole.p_WG, m_hip});
        }
    }

    /// @param layer  number in the engine's scene
    void judgeGroup(std::size_t g, std::size_t layer, const TickResult& whole, const haptics::PalpatorState& state,
                    Faults& faults)
    {
        GroupAtRest& group = m_groups[g];
        const RandomMotion* const motion = motionOf(g);
        const Vec3 X = motion == nullptr ? m_hip : state.p_RH[layer];
        const Vec3 god_R = state.layers[layer].p_WG;
        if (!X.allFinite() || !god_R.allFinite() || !whole.f_W.allFinite()) {
            faults.push_back({"not finite", 0.0, "", god_R, X});
            forget(group);
            return;
        }
        const Vec3 vTissue = motion == nullptr ? Vec3::Zero() : motion->velocity(m_t, X);
        const Mat3 F = motion == nullptr ? Mat3::Identity() : motion->gradient(m_t, X);
        const double hand_mm =
            motion == nullptr ? 0.0 : (motion->toWorld(m_t, X) - m_hip).norm() - motion->placeError(m_t, X);
        if (!(hand_mm <= kInverse_mm + m_rounding_mm)) {
            faults.push_back({"another rest position than the hand's", hand_mm, "mm", X, m_hip});
        }
        const Vec3 v_R = m_hasStarted ? Vec3(F.inverse() * (m_v - vTissue)) : Vec3::Zero();
        const TickResult one = group.palpator.step(X, m_dt_s, &v_R);
        const haptics::GodObjectState alone = group.palpator.state().layers[0];
        const bool isSame = sameBits(alone.p_WG, god_R) && alone.constraints == state.layers[layer].constraints;
        const bool isReturning = std::exchange(group.isReturning, false);
        if ((m_isAtBound || isReturning) && !isSame) { // layers share the work of a tick
            haptics::PalpatorState shared = group.palpator.state();
            shared.layers[0] = state.layers[layer];
            group.palpator.restore(shared);
            forget(group);
            m_isPowerKnown = false;
            return;
        }
        if (!isSame) {
            faults.push_back({"another god-object than at rest", (alone.p_WG - god_R).norm(), "mm", alone.p_WG, god_R});
            return;
        }
        group.judge->look(one, X, v_R, m_chance.is(Odds::rest), faults);
        judgeWorld(g, ofLayer(whole, layer), one, X, god_R, F, vTissue, faults);
        if (m_chance.is(Odds::nodes)) {
            const Vec3 god = motion == nullptr ? god_R : motion->toWorld(m_t, god_R);
            group.nodes->look(m_t, god, m_rounding_mm + 2.0 * kInverse_mm, faults);
        }
    }

    /// Checks what the engine says of a group in the world.
    void judgeWorld(std::size_t g, const OfLayer& is, const TickResult& one, const Vec3& X, const Vec3& god_R,
                    const Mat3& F, const Vec3& vTissue, Faults& faults)
    {
        GroupAtRest& group = m_groups[g];
        const RandomMotion* const motion = motionOf(g);
        const double s = motion == nullptr ? 0.0 : motion->strain(),
                     factor = motion == nullptr ? 1.0 : motion->factor(m_t);
        const Mat3 invF = F.inverse();
        const Vec3 force = factor * invF.transpose() * one.f_W;
        // The engine's ∂φ/∂X is that before the last step of the inverse, which was shorter than this.
        const double bend = motion == nullptr ? 0.0 : motion->bend_per_mm();
        const double offF = std::sqrt(2.0 * kInverse_mm * bend) + (motion == nullptr ? 0.0 : motion->gradientError(X));
        const double off_mm = bend > 0.0 ? std::sqrt(2.0 * kInverse_mm / bend) : 0.0;
        const double offV = (motion == nullptr ? 0.0 : motion->rate_per_s() * off_mm + motion->velocityError(m_t, X)) +
                            1e-6 * vTissue.norm() + 2.0 * offF * (m_v - vTissue).norm();
        const double slack = (4.0 * offF / (1.0 - s) + 1e-9) * force.norm() + 2.0 * factor * group.mostDamping * offV +
                             1e-9 * group.stiffest * m_rounding_mm;
        if (is.count == 0 ? !one.f_W.isZero(0.0) : !((is.force - force).norm() <= slack)) {
            faults.push_back({"another force than that at rest, taken to the world", (is.force - force).norm(), "N",
                              is.force, force});
        }
        const Vec3 god = motion == nullptr ? god_R : motion->toWorld(m_t, god_R);
        if (is.count > 0 &&
            !((is.god - god).norm() <=
              kInverse_mm + m_rounding_mm + (motion == nullptr ? 0.0 : motion->placeError(m_t, god_R)))) {
            faults.push_back({"another place of the god-object", (is.god - god).norm(), "mm", is.god, god});
        }
        const double most = group.stiffest * factor * (god - m_hip).norm() / ((1.0 - s) * (1.0 - s));
        if (group.isPlain &&
            !(is.force.norm() <= (1.0 + 1e-6) * most + group.stiffest * (m_rounding_mm + kInverse_mm))) {
            faults.push_back({"more force than the spring's", is.force.norm() - most, "N", is.force, force});
        }
        addPower(g, is, one, X, god_R, vTissue, offV);
        judgeHeld(group, is.count > 0 ? is.force : Vec3(Vec3::Zero()), god, one, faults);
        if (motion != nullptr && is.count == 1 && m_chance.is(Odds::derive)) {
            judgeDerivatives(g, is.force, one, vTissue, faults);
        }
    }

    void addPower(std::size_t g, const OfLayer& is, const TickResult& one, const Vec3& X, const Vec3& god_R,
                  const Vec3& vTissue, double offV)
    {
        const RandomMotion* const motion = motionOf(g);
        if (motion == nullptr || is.count == 0) {
            return;
        }
        m_power_mW += is.force.dot(vTissue);
        m_powerSlack_mW += is.force.norm() * (offV + 1e-5 * vTissue.norm());
        const double slope = motion->factorSlope(m_t);
        if (slope != 0.0) {
            m_isPowerKnown = m_isPowerKnown && m_groups[g].isPlain && is.count == 1;
            const double k = m_scene.rest.structures[one.contacts[0].structure].tissue.stiffness_N_per_mm;
            const double stored = 0.5 * k * (god_R - X).squaredNorm();
            m_power_mW += slope * stored;
            m_powerSlack_mW += 1e-5 * std::abs(slope) * stored;
        }
        if (motion->isPulsing()) { // the slope is rounded, also where differences of the factor are 0
            m_powerSlack_mW += 5e-7 * is.force.norm() * (god_R - X).norm(); // 1e-6 of the energy
        }
    }

    /// Checks that hand and god-object rest where the motion is held.
    void judgeHeld(GroupAtRest& group, const Vec3& force, const Vec3& god, const TickResult& one, Faults& faults)
    {
        constexpr int kSettled = 8;
        const double step_mm = (god - group.god).norm();
        const double may_mm = 4.0 * kInverse_mm + 64.0 * group.skin_mm + m_rounding_mm + 1e-8 * (god - m_hip).norm();
        // Friction that drags lets the god-object follow over some ticks.
        if (m_stillTicks > kSettled && !group.isDragged && one.status == TickStatus::Converged && !m_isAtBound) {
            ++m_tally.heldTicks;
            if (step_mm > may_mm) {
                faults.push_back({"moves while everything is held", step_mm, "mm", group.god, god});
            } else if (group.isPlain && (force - group.force).norm() > 4.0 * group.stiffest * may_mm) {
                faults.push_back(
                    {"force changes while everything is held", (force - group.force).norm(), "N", group.force, force});
            }
        }
        group.god = god;
        group.force = force;
    }

    /// Checks by differences that the force is minus the gradient of the stored energy in the hand's place, and the
    /// power of the tissue its change in time: a point on the inside of one facet of a linear spring.
    void judgeDerivatives(std::size_t g, const Vec3& force, const TickResult& one, const Vec3& vTissue, Faults& faults)
    {
        const GroupAtRest& group = m_groups[g];
        if (one.constraints != 1 || one.status != TickStatus::Converged || !group.isPlain ||
            m_scene.rest.fingertip_mm > 0.0) {
            return;
        }
        const RandomMotion& motion = *motionOf(g);
        const haptics::ActiveConstraint& plane = one.active[0];
        const RandomStructure& on = m_scene.rest.structures[plane.structure];
        const Vec3 corner = on.surface->vertex(on.surface->triangle(plane.triangle)[0]);
        const Vec3 foot = one.p_WG;
        // The god-object is within the facet: its distance is that of the plane.
        const Vec3 spring = foot - (motion.toRest(m_t, m_hip.cast<long double>())).cast<double>();
        const double depth = plane.n_W.dot(spring);
        if (!(depth > 1e-4 * m_scene.rest.scale) || (spring - depth * plane.n_W).norm() > 1e-9 * depth) {
            return;
        }
        ++m_tally.derivedTicks;
        const double k = on.tissue.stiffness_N_per_mm;
        const auto energy = [&](const Long3& p, double t) {
            const Long3 X = motion.toRest(t, p);
            const long double d = plane.n_W.cast<long double>().dot(corner.cast<long double>() - X);
            return static_cast<long double>(motion.factor(t)) * 0.5L * k * d * d;
        };
        const Long3 p = m_hip.cast<long double>();
        const long double h = 1e-4L * depth;
        Vec3 gradient;
        for (int n = 0; n < 3; ++n) {
            const Long3 step = h * Long3::Unit(n);
            gradient[n] = static_cast<double>((energy(p + step, m_t) - energy(p - step, m_t)) / (2 * h));
        }
        const double near = 1e-4 +
                            4.0 * (std::sqrt(2.0 * kInverse_mm * motion.bend_per_mm()) + motion.gradientError(m_hip)) +
                            4.0 * (64.0 * group.skin_mm + m_rounding_mm + kInverse_mm) / depth;
        if (!((force + gradient).norm() <= near * force.norm())) {
            faults.push_back(
                {"force is not the gradient of the energy", (force + gradient).norm(), "N", force, -gradient});
        }
        if (motion.timeStep_s() > 0.0) {
            const double step_s = motion.timeStep_s();
            const double change = double(energy(p, m_t + step_s) - energy(p, m_t - step_s)) / (2.0 * step_s);
            const double stored = double(energy(p, m_t)) / motion.factor(m_t);
            const double power = force.dot(vTissue) + motion.factorSlope(m_t) * stored;
            const double slack = near * (force.norm() * vTissue.norm() + std::abs(motion.factorSlope(m_t)) * stored) +
                                 force.norm() * motion.velocityError(m_t, one.p_WG) +
                                 1e-15 * (std::abs(m_t) + 1.0) * double(energy(p, m_t)) / step_s + 1e-4 * stored +
                                 1e-15 * m_hip.norm() * force.norm() / step_s;
            if (!(std::abs(change - power) <= slack)) {
                faults.push_back({"power is not the change of the energy", change - power, "mW", force, vTissue});
            }
        }
    }

    void print(const TickResult& tick) const
    {
        std::printf(
            "tick %lld, HIP (%.17g %.17g %.17g): god-object (%.17g %.17g %.17g), force (%g %g %g), structure %d, "
            "%d constraints, %d contacts, %u moves, status %d\n",
            static_cast<long long>(m_number), m_hip.x(), m_hip.y(), m_hip.z(), tick.p_WG.x(), tick.p_WG.y(),
            tick.p_WG.z(), tick.f_W.x(), tick.f_W.y(), tick.f_W.z(), tick.structure, static_cast<int>(tick.constraints),
            static_cast<int>(tick.contactCount), tick.iterations, static_cast<int>(tick.status));
    }

    void say(const Fault& fault)
    {
        char text[96];
        std::snprintf(text, sizeof text, ", radius %g, scale %.3g, tick of %g ms", m_scene.rest.fingertip_mm,
                      m_scene.rest.scale, 1e3 * m_dt_s);
        m_log.add(fault, m_number, m_hip, m_scene.name() + text);
    }

    Tally& m_tally;
    FaultLog m_log;
    Chance m_chance;
    MovingScene m_scene;
    bool m_isExact; ///< hands on vertices, on edges and in planes
    MovingHand m_hand;
    double m_dt_s;
    std::vector<GroupAtRest> m_groups;
    std::uint32_t m_shown; ///< one bit per group
    std::unique_ptr<haptics::HapticScene> m_sceneNow;
    std::size_t m_sceneNumber = 0; ///< of GroupAtRest::scenes
    Palpator m_whole, m_twin;
    int m_compared = 0;   ///< remaining ticks of comparison with the restored twin
    int m_stillTicks = 0; ///< ticks with hand and motions at rest
    bool m_isHeld = false, m_isStill = false, m_isAtBound = false, m_hasStarted = false;
    Vec3 m_hip = Vec3::Zero(), m_v = Vec3::Zero();
    double m_t = 0.0, m_rounding_mm = 0.0;
    double m_power_mW = 0.0, m_powerSlack_mW = 0.0;
    bool m_isPowerKnown = false;
    std::int64_t m_number = 0;
};

} // namespace

void playMoving(std::uint64_t seed, std::int64_t ticks, Tally& tally)
{
    MovingGame game(seed, tally);
    for (std::int64_t i = 0; i < ticks; ++i) {
        game.tick(i);
    }
    game.finish();
}

} // namespace palpate::adversary
