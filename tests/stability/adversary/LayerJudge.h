// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "EnergyJudge.h"
#include "JudgedLayer.h"
#include "SharedJudge.h"

#include <palpate/haptics/Palpator.h>

#include <functional>

namespace palpate::adversary {

/// Something that the engine must not do.
struct Fault
{
    std::string what;
    double amount = 0.0;
    std::string unit;
    Vec3 from = Vec3::Zero(), to = Vec3::Zero(); ///< god-object before and after, or where it could have gone [mm]
};
using Faults = std::vector<Fault>;

/// Watches the god-object of one layer, tick by tick.
class LayerJudge
{
  public:
    LayerJudge(const RandomScene& scene, std::uint32_t layer, std::uint64_t seed);

    /// The god-object was put down anew: what was known of where it may be is not so any more.
    void forget();
    /// Judges one tick.
    /// @param v_WH  velocity of the hand, for the damper [mm/s]
    /// @param isRestJudged  looks for a way closer to the HIP, which takes some hundred times as long as the rest
    void look(const haptics::TickResult& tick, const Vec3& hip, const Vec3& v_WH, bool isRestJudged, Faults& faults);
    /// Ticks in which the ways of a sheet's two sides were told apart, and in which rest was judged.
    [[nodiscard]] std::int64_t sheetTicks() const { return m_sheetTicks; }
    [[nodiscard]] std::int64_t restTicks() const { return m_restTicks; }
    /// Ticks whose energy was summed.
    [[nodiscard]] std::int64_t energyTicks() const { return m_energy.ticks(); }

  private:
    struct BodyWatch
    {
        bool isKnown = false;
        int most = 0;         ///< winding number
        int outsideTicks = 0; ///< for how many ticks the god-object has been outside
    };
    struct SheetWatch
    {
        bool isKnown = false;
        Vec3 place = Vec3::Zero(); ///< beside the sheet, where the god-object was last or next to it
        bool isOdd = false; ///< the places so far, joined by straight lines, pass the sheet an odd number of times
    };
    void judgeDistance(const Vec3& god, const Vec3& hip, Faults& faults);
    void judgeForce(const haptics::TickResult& tick, const Vec3& hip, const Vec3& v_WH, Faults& faults);
    void judgeBodies(const Vec3& god, Faults& faults);
    void judgeSheet(const Sheet& sheet, SheetWatch& watch, const Vec3& god, const Vec3& hip, Faults& faults);
    void judgeBall(const Vec3& god, Faults& faults);
    void judgeRest(const Vec3& god, const Vec3& hip, Faults& faults);
    [[nodiscard]] double aside_mm(const haptics::TickResult& tick, const Vec3& hip) const;
    void judgeFriction(const haptics::TickResult& tick, const Vec3& hip, Faults& faults) const;
    [[nodiscard]] double distance_mm(const Sheet& sheet, const Vec3& p) const;
    [[nodiscard]] std::optional<bool> isCrossed(const Sheet& sheet, const Vec3& from, const Vec3& to) const;

    const RandomScene& m_scene;
    JudgedLayer m_layer;
    Chance m_chance;
    double m_magnitude_mm, m_rounding_mm = 0.0;
    std::vector<haptics::HapticStructure> m_structures; ///< by number in the scene
    bool m_isRough = false;                             ///< some structure of the layer has friction
    bool m_hasDrag = false;
    bool m_isPlaced = false;
    bool m_isDeep = false; ///< a ball that is nearer to something than its radius
    Vec3 m_god = Vec3::Zero();
    std::vector<BodyWatch> m_bodies;
    std::vector<SheetWatch> m_sheets;
    EnergyJudge m_energy;
    SharedJudge m_shared;
    double m_near_mm = 0.0; ///< of a ball's centre, to whatever is nearest; its radius where that is less
    std::int64_t m_sheetTicks = 0, m_restTicks = 0;
};

/// The best of some tens of straight moves from `god`, none of which anything could block.
struct WayCloser
{
    double gain_mm = 0.0;
    Vec3 to = Vec3::Zero();
};
/// @param enough_mm  of a smaller gain nothing is said
/// @param mayEnd  whether the god-object may be at a place at all
[[nodiscard]] WayCloser wayCloser(const JudgedLayer& layer, const Vec3& god, const Vec3& hip, double fingertip_mm,
                                  double enough_mm, const std::function<bool(const Vec3&)>& mayEnd, Chance& chance);

} // namespace palpate::adversary
