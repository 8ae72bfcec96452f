// SPDX-License-Identifier: BSD-3-Clause
#include "EnergyJudge.h"

#include "TissueJudge.h"

#include <algorithm>
#include <cmath>

namespace palpate::adversary {

namespace {

/// Returns the largest deviation of a step over which the map rises by `rise`: see the class.
/// @param before  W before the step
double mayMake_mJ(const haptics::HapticStructure& on, double before, double sShare, double rise, const Vec3& spring,
                  const Vec3& n)
{
    const double depth = spring.norm(), lambda = n.dot(spring);
    if (!on.tissue.hasFriction()) {
        return std::abs(rise) * std::abs(before - on.lawAt(depth).energy_mJ);
    }
    // At this depth and with this law, friction of (W/F) |grad ln s| dissipates this fraction.
    const haptics::ForceTable::Value held = on.lawAt(lambda);
    const double stiffer = on.lawAt(depth).force_N / depth / (held.force_N / lambda);
    return std::max(0.0, rise) *
           std::max(0.0, before - std::min(1.0, stiffer) * std::min(1.0, sShare) * held.energy_mJ);
}

} // namespace

std::optional<EnergyJudge::Touch> EnergyJudge::touchOf(const std::vector<haptics::HapticStructure>& structures,
                                                       const haptics::TickResult& tick, const Vec3& hip)
{
    if (tick.constraints != 1 || tick.status != haptics::TickStatus::Converged) {
        return std::nullopt;
    }
    const haptics::ActiveConstraint& plane = tick.active[0];
    const haptics::HapticStructure& on = structures[plane.structure];
    const PlaceOnTriangle place(*on.surface, plane.triangle, tick.p_WG);
    const double depth = (tick.p_WG - hip).norm();
    if (!place.isInside() || !on.isMonotonic() || on.maps.stiffness.bendsOn(plane.triangle) ||
        !(plane.n_W.dot(tick.p_WG - hip) > 0.0)) {
        return std::nullopt;
    }
    const haptics::TissueMaps& maps = on.maps;
    return Touch{plane.structure,
                 plane.triangle,
                 hip,
                 tick.p_WG,
                 maps.stiffness.isEmpty() ? 1.0 : place.valueOf(maps.stiffness),
                 maps.damping.isEmpty() ? on.tissue.damping_Ns_per_mm : place.valueOf(maps.damping),
                 on.lawAt(depth).energy_mJ,
                 maps.stiffness.isEmpty() ? 0.0 : place.slopeOf(maps.stiffness),
                 maps.damping.isEmpty() ? 0.0 : place.slopeOf(maps.damping)};
}

double EnergyJudge::made_mJ(const std::vector<haptics::HapticStructure>& structures, const haptics::TickResult& tick,
                            const Vec3& hip, const Vec3& v_WH, double rounding_mm)
{
    const std::optional<Touch> last = m_last, now = m_last = touchOf(structures, tick, hip);
    if (!last || !now || last->structure != now->structure || last->triangle != now->triangle) {
        return 0.0;
    }
    ++m_ticks;
    const haptics::HapticStructure& on = structures[now->structure];
    const Vec3 elastic = tick.f_W + now->damping * v_WH, moved = now->hip - last->hip;
    const double more = now->s * now->W - last->s * last->W + elastic.dot(moved);
    const double may =
        mayMake_mJ(on, last->W, now->s / last->s, now->s - last->s, now->god - now->hip, tick.active[0].n_W);
    // The god-object is some skins above the face, and its position on the face has the same uncertainty.
    const double place = 64.0 * on.surface->skin_mm() + rounding_mm;
    const double k = now->s * (on.law == nullptr ? on.tissue.stiffness_N_per_mm : on.law->greatestSlope_N_per_mm());
    const double slack = 1e-9 * (now->s * now->W + last->s * last->W + elastic.norm() * moved.norm()) +
                         place * (elastic.norm() + now->slope_per_mm * (now->W + last->W)) +
                         place * k * (place + moved.norm()) +
                         (1e-9 * now->damping + place * now->dampingSlope) * v_WH.norm() * moved.norm();
    return std::max(0.0, more - (1.0 + 1e-6) * may - slack);
}

} // namespace palpate::adversary
