// SPDX-License-Identifier: BSD-3-Clause
#include "Game.h"

#include "FaultLog.h"
#include "MovingGame.h"
#include "RandomHand.h"
#include "SameBits.h"

#include <bit>
#include <cstdio>
#include <cstring>
#include <limits>
#include <utility>

namespace palpate::adversary {

namespace {

using haptics::Palpator;
using haptics::TickResult;
using haptics::TickStatus;

constexpr double kTick_s = 1e-3;
// Probabilities per tick: check the rest position; restore another Palpator from the state; hide or show a layer;
// reset; pass invalid input.
constexpr double kRest = 0.02, kRestore = 1e-3, kSwitch = 5e-3, kReset = 2e-4, kBad = 5e-4;

/// A single layer, for comparison with the sum of all layers and for the checks.
struct Alone
{
    std::unique_ptr<haptics::HapticScene> scene;
    Palpator palpator;
    std::unique_ptr<LayerJudge> judge;
};

class Game
{
  public:
    Game(Family family, std::uint64_t seed, Tally& tally)
        : m_tally(tally)
        , m_log(family, seed, tally)
        , m_chance(firstOf(family, seed))
        , m_scene(randomScene(family, m_chance))
        , m_isExact(m_chance.is(0.5))
        , m_hand(m_scene, m_isExact, m_chance.bits())
        , m_alone(m_scene.layers)
        , m_shown((1u << m_scene.layers) - 1)
    {
        for (std::uint32_t i = 0; i < m_scene.layers; ++i) {
            m_alone[i].scene = m_scene.build(1u << i);
            m_alone[i].palpator.borrowScene(m_alone[i].scene.get());
            m_alone[i].judge = std::make_unique<LayerJudge>(m_scene, i, m_chance.bits());
        }
        m_whole.borrowScene(sceneShowing(m_shown));
    }

    void tick(std::int64_t number)
    {
        m_number = number;
        Vec3 hip = m_hand.next();
        if (m_chance.is(kReset)) {
            reset();
        }
        if (m_chance.is(kBad)) {
            bad(hip);
            return;
        }
        if (m_scene.layers > 1 && number > 0 && m_chance.is(kSwitch)) {
            hip = m_hip; // the hand rests while layers change
            switchLayer();
        }
        const bool isRestored = m_compared == 0 && m_chance.is(kRestore);
        if (isRestored) {
            m_twin.borrowScene(m_whole.scene());
            m_twin.restore(m_whole.state());
            m_compared = m_chance.whole(5, 60);
            ++m_tally.restores;
        }
        step(hip);
    }

    void finish()
    {
        for (const Alone& alone : m_alone) {
            m_tally.sheetTicks += alone.judge->sheetTicks();
            m_tally.restTicks += alone.judge->restTicks();
            m_tally.energyTicks += alone.judge->energyTicks();
        }
        m_tally.failedSeeds += m_log.isEmpty() ? 0 : 1;
    }

  private:
    const haptics::HapticScene* sceneShowing(std::uint32_t shown)
    {
        auto& scene = m_scenes[shown];
        if (!scene) {
            scene = m_scene.build(shown);
        }
        return scene.get();
    }

    void reset()
    {
        m_whole.reset();
        m_compared = 0;
        m_hasStarted = false;
        for (Alone& alone : m_alone) {
            alone.palpator.reset();
            alone.judge->forget();
        }
    }

    /// Hides or shows a layer. The other layers get their scenes again, so that each has released the same contacts.
    void switchLayer()
    {
        const auto layer = static_cast<std::uint32_t>(m_chance.below(m_scene.layers));
        m_shown ^= 1u << layer;
        m_whole.borrowScene(sceneShowing(m_shown));
        m_compared = 0;
        ++m_tally.switches;
        for (std::uint32_t i = 0; i < m_scene.layers; ++i) {
            m_alone[i].palpator.borrowScene((m_shown >> i & 1u) != 0 ? m_alone[i].scene.get() : nullptr);
        }
        m_alone[layer].judge->forget();
    }

    /// Non-finite input causes no motion and no force.
    void bad(Vec3 hip)
    {
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        hip[m_chance.whole(0, 2)] = m_chance.is(0.5) ? std::numeric_limits<double>::quiet_NaN() : -kInfinity;
        const haptics::PalpatorState before = m_whole.state();
        const TickResult tick = m_whole.step(hip, kTick_s);
        const haptics::PalpatorState after = m_whole.state();
        bool isSame = tick.f_W.isZero(0.0) && tick.status == TickStatus::InvalidInput;
        for (std::size_t i = 0; i < before.layers.size(); ++i) {
            isSame = isSame && sameBits(before.layers[i].p_WG, after.layers[i].p_WG);
        }
        if (m_compared > 0) {
            (void)m_twin.step(hip, kTick_s);
        }
        if (!isSame) {
            say({"bad input moved or pushed something", 0.0, "", Vec3::Zero(), Vec3::Zero()});
        }
    }

    void step(const Vec3& hip)
    {
        const Vec3 v_WH = m_hasStarted ? Vec3((hip - m_hip) / kTick_s) : Vec3::Zero();
        const TickResult whole = m_whole.step(hip, kTick_s);
        ++m_tally.ticks;
        m_tally.inContact += whole.constraints > 0 ? 1 : 0;
        m_tally.atBound += whole.status == TickStatus::IterationLimit ? 1 : 0;
        Vec3 sum = Vec3::Zero();
        double size = 0.0;
        Faults faults;
        const bool isRestJudged = m_chance.is(kRest);
        for (std::uint32_t i = 0; i < m_scene.layers; ++i) {
            const TickResult one = m_alone[i].palpator.step(hip, kTick_s);
            sum += one.f_W;
            size += one.f_W.norm();
            if ((m_shown >> i & 1u) != 0) {
                m_alone[i].judge->look(one, hip, v_WH, isRestJudged, faults);
            }
        }
        if (whole.status == TickStatus::IterationLimit) {
            followAtBound(faults);
        } else if (!(((whole.f_W - sum).norm() <= 1e-12 * size))) {
            faults.push_back(
                {"force is not the sum of the layers' forces", (whole.f_W - sum).norm(), "N", sum, whole.f_W});
        }
        if (m_compared > 0) {
            --m_compared;
            const TickResult twin = m_twin.step(hip, kTick_s);
            if (!sameBits(whole, twin)) {
                m_compared = 0;
                if (m_number >= m_tally.printedFrom && m_number <= m_tally.printedTo) {
                    print(twin);
                }
                faults.push_back({sameBits(whole.p_WG, twin.p_WG) && sameBits(whole.f_W, twin.f_W)
                                      ? "restored: other numbers than position and force"
                                      : "restored: other bits of position or force",
                                  (whole.p_WG - twin.p_WG).norm(), "mm", whole.p_WG, twin.p_WG});
            }
        }
        m_hip = hip;
        m_hasStarted = true;
        if (m_number >= m_tally.printedFrom && m_number <= m_tally.printedTo) {
            print(whole);
        }
        for (const Fault& fault : faults) {
            say(fault);
        }
    }

    /// Layers share the work of a tick: at the bound only the innermost layer must match the single layer. The others
    /// continue from their common state.
    void followAtBound(Faults& faults)
    {
        haptics::PalpatorState whole = m_whole.state();
        auto place = static_cast<std::size_t>(std::popcount(m_shown));
        for (std::uint32_t i = m_scene.layers; i-- > 0;) {
            if ((m_shown >> i & 1u) == 0) {
                continue;
            }
            Alone& alone = m_alone[i];
            const haptics::GodObjectState& together = whole.layers[--place];
            haptics::PalpatorState state = alone.palpator.state();
            const Vec3 apart = std::exchange(state.layers[0], together).p_WG;
            alone.palpator.restore(state);
            if (sameBits(apart, together.p_WG)) {
                continue;
            }
            alone.judge->forget();
            if (place + 1 == static_cast<std::size_t>(std::popcount(m_shown))) {
                faults.push_back({"outer layers have moved the innermost", (apart - together.p_WG).norm(), "mm", apart,
                                  together.p_WG});
            }
        }
    }

    void print(const TickResult& tick) const
    {
        std::printf(
            "tick %lld, HIP (%.17g %.17g %.17g): god-object (%.17g %.17g %.17g), force (%g %g %g), structure %d, "
            "triangle %u, %d constraints, %u moves, status %d, friction %d\n",
            static_cast<long long>(m_number), m_hip.x(), m_hip.y(), m_hip.z(), tick.p_WG.x(), tick.p_WG.y(),
            tick.p_WG.z(), tick.f_W.x(), tick.f_W.y(), tick.f_W.z(), tick.structure, tick.triangle,
            static_cast<int>(tick.constraints), tick.iterations, static_cast<int>(tick.status),
            static_cast<int>(tick.friction()));
    }

    void say(const Fault& fault)
    {
        char text[256];
        std::snprintf(text, sizeof text, "%s, radius %g, scale %.3g, %s HIPs", m_scene.name.c_str(),
                      m_scene.fingertip_mm, m_scene.scale, m_isExact ? "exact" : "general");
        m_log.add(fault, m_number, m_hip, text);
    }

    Tally& m_tally;
    FaultLog m_log;
    Chance m_chance;
    RandomScene m_scene;
    bool m_isExact; ///< HIPs on vertices, on edges and in planes
    RandomHand m_hand;
    std::vector<Alone> m_alone;
    std::uint32_t m_shown; ///< one bit per layer
    std::map<std::uint32_t, std::unique_ptr<haptics::HapticScene>> m_scenes;
    Palpator m_whole, m_twin;
    int m_compared = 0; ///< remaining ticks of comparison with the restored twin
    Vec3 m_hip = Vec3::Zero();
    bool m_hasStarted = false;
    std::int64_t m_number = 0;
};

} // namespace

std::string Tally::summary() const
{
    char text[400];
    std::snprintf(text, sizeof text,
                  "%lld ticks, %lld in contact, %lld at the bound; %lld sides of sheets, %lld times at rest judged, "
                  "%lld times energy, %lld "
                  "restored, %lld layers switched; %lld seeds failed",
                  static_cast<long long>(ticks), static_cast<long long>(inContact), static_cast<long long>(atBound),
                  static_cast<long long>(sheetTicks), static_cast<long long>(restTicks),
                  static_cast<long long>(energyTicks), static_cast<long long>(restores),
                  static_cast<long long>(switches), static_cast<long long>(failedSeeds));
    std::string result = text;
    if (nodeTicks > 0) {
        result += "; " + std::to_string(nodeTicks) + " moved surfaces, " + std::to_string(heldTicks) + " times held, " +
                  std::to_string(derivedTicks) + " derivatives judged";
    }
    for (const auto& [what, seeds] : seedsByFault) {
        result += "; " + what + ": " + std::to_string(seeds);
    }
    return result;
}

void play(Family family, std::uint64_t seed, std::int64_t ticks, Tally& tally)
{
    if (family == Family::Moving) {
        playMoving(seed, ticks, tally);
        return;
    }
    Game game(family, seed, tally);
    for (std::int64_t i = 0; i < ticks; ++i) {
        game.tick(i);
    }
    game.finish();
}

Tally playMany(Family family, std::uint64_t first, std::int64_t ticks)
{
    Tally tally;
    for (std::uint64_t seed = first; tally.ticks < ticks; ++seed) {
        play(family, seed, kTicksOfSeed, tally);
    }
    return tally;
}

} // namespace palpate::adversary
