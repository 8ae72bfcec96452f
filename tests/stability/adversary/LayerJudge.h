// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "EnergyJudge.h"
#include "JudgedLayer.h"
#include "SharedJudge.h"

#include <palpate/haptics/Palpator.h>

#include <functional>

namespace palpate::adversary {

/// A violation by the engine.
struct Fault
{
    std::string what;
    double amount = 0.0;
    std::string unit;
    Vec3 from = Vec3::Zero(), to = Vec3::Zero(); ///< god-object before and after, or a better position [mm]
};
using Faults = std::vector<Fault>;

/// Checks the god-object of one layer, tick by tick.
class LayerJudge
{
  public:
    LayerJudge(const RandomScene& scene, std::uint32_t layer, std::uint64_t seed);

    /// Forgets the known state after the god-object was placed again.
    void forget();
    /// Checks one tick.
    /// @param v_WH  velocity of the hand, for the damper [mm/s]
    /// @param isRestJudged  also searches for a legal move closer to the HIP, at some hundred times the cost
    void look(const haptics::TickResult& tick, const Vec3& hip, const Vec3& v_WH, bool isRestJudged, Faults& faults);
    /// Returns the number of ticks in which the sides of a sheet could be distinguished, and of ticks with a checked
    /// rest position.
    [[nodiscard]] std::int64_t sheetTicks() const { return m_sheetTicks; }
    [[nodiscard]] std::int64_t restTicks() const { return m_restTicks; }
    /// Returns the number of ticks in the energy sum.
    [[nodiscard]] std::int64_t energyTicks() const { return m_energy.ticks(); }

  private:
    struct BodyWatch
    {
        bool isKnown = false;
        int most = 0;         ///< winding number
        int outsideTicks = 0; ///< number of ticks that the god-object has been outside
    };
    struct SheetWatch
    {
        bool isKnown = false;
        Vec3 place = Vec3::Zero(); ///< off the sheet, at or next to the last god-object position
        bool isOdd = false;        ///< the polyline of positions so far crosses the sheet an odd number of times
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
    bool m_isRough = false;                             ///< a structure of the layer has friction
    bool m_hasDrag = false;
    bool m_isPlaced = false;
    bool m_isDeep = false; ///< a ball nearer to a facet than its radius
    Vec3 m_god = Vec3::Zero();
    std::vector<BodyWatch> m_bodies;
    std::vector<SheetWatch> m_sheets;
    EnergyJudge m_energy;
    SharedJudge m_shared;
    double m_near_mm = 0.0; ///< distance of the ball's centre to the nearest facet, at most the radius
    std::int64_t m_sheetTicks = 0, m_restTicks = 0;
};

/// The best of some tens of straight moves from `god` that no facet could block.
struct WayCloser
{
    double gain_mm = 0.0;
    Vec3 to = Vec3::Zero();
};
/// @param enough_mm  smaller gains are not reported
/// @param mayEnd  whether the god-object may be at a position
[[nodiscard]] WayCloser wayCloser(const JudgedLayer& layer, const Vec3& god, const Vec3& hip, double fingertip_mm,
                                  double enough_mm, const std::function<bool(const Vec3&)>& mayEnd, Chance& chance);

} // namespace palpate::adversary
