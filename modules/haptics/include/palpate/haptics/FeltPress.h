// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/HapticScene.h"

#include <palpate/core/Realtime.h>

#include <array>
#include <cstddef>

namespace palpate::haptics {

/// Weights of a structure's transmission maps ("felt" maps of buried lumps) at a given penetration depth.
/// With s_j the value of map j at the contact point, the force is `F(d) sum_j s_j B_j(d)` and the stored energy is
/// `sum_j s_j W_j(d)`, where `W_j = integral of B_j F` and B_j is the piecewise linear function of depth that is 1 at
/// kFeltPress_mm[j] and 0 at the other knots.
/// @par Source docs/felt.md
struct FeltPress
{
    static constexpr std::size_t kCount = kFeltPress_mm.size();
    static constexpr auto kPerWidth = [] {
        std::array<double, kCount - 1> inverse{};
        for (std::size_t j = 0; j < inverse.size(); ++j) {
            inverse[j] = 1.0 / (kFeltPress_mm[j + 1] - kFeltPress_mm[j]);
        }
        return inverse;
    }(); ///< reciprocal widths of the depth intervals [1/mm]

    std::array<double, kCount> weights{};  ///< B_j(d) [1]
    std::array<double, kCount> energies{}; ///< W_j(d) [mJ]

    /// Interpolates the scale factor only, for callers that do not need the energy: `sum_j s_j B_j(d)` has at most two
    /// nonzero terms.
    /// @param at  returns s_j for index j
    /// @param depth_mm  penetration depth d > 0
    /// @par Real-time Wait-free.
    template<class At>
    [[nodiscard]] PALPATE_ALWAYS_INLINE static double scaleAt(double depth_mm, const At& at) noexcept
    {
        if (depth_mm > kFeltPress_mm.back()) {
            return at(kCount - 1);
        }
        std::size_t j = 0;
        while (depth_mm > kFeltPress_mm[j + 1]) {
            ++j;
        }
        const double second = (depth_mm - kFeltPress_mm[j]) * kPerWidth[j];
        return (1.0 - second) * at(j) + second * at(j + 1);
    }
    /// Computes weights and energies.
    /// @param on  structure in contact
    /// @param depth_mm  penetration depth d > 0
    /// @param law  value of the structure's force law at `depth_mm`
    /// @par Real-time Wait-free.
    [[nodiscard]] PALPATE_ALWAYS_INLINE static FeltPress at(const HapticStructure& on, double depth_mm,
                                                            const ForceTable::Value& law) noexcept
    {
        FeltPress press;
        double energy = 0.0, moment = 0.0; // of the force law at depth `from`
        for (std::size_t j = 0; j + 1 < kCount && depth_mm > kFeltPress_mm[j]; ++j) {
            const double from = kFeltPress_mm[j], perWidth = kPerWidth[j];
            const bool endsHere = depth_mm <= kFeltPress_mm[j + 1];
            const double to = endsHere ? depth_mm : kFeltPress_mm[j + 1];
            const double energyTo = endsHere ? law.energy_mJ : on.lawAt(to).energy_mJ, momentTo = on.momentAt(to);
            // Integral over [from, to] of F times the ramp that rises from 0 at kFeltPress_mm[j] to 1 at
            // kFeltPress_mm[j + 1].
            const double rising = (momentTo - moment - from * (energyTo - energy)) * perWidth;
            press.energies[j] += energyTo - energy - rising;
            press.energies[j + 1] += rising;
            if (endsHere) {
                press.weights[j + 1] = (depth_mm - from) * perWidth;
                press.weights[j] = 1.0 - press.weights[j + 1];
            }
            energy = energyTo;
            moment = momentTo;
        }
        if (depth_mm > kFeltPress_mm.back()) {
            press.weights.back() = 1.0;
            press.energies.back() += law.energy_mJ - energy;
        }
        return press;
    }
};

} // namespace palpate::haptics
