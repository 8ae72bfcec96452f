// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/HapticScene.h"

#include <palpate/core/Realtime.h>

#include <array>
#include <cstddef>

namespace palpate::haptics {

/// How much each of a structure's felt maps counts in a press: with s_j what they say at a place, the force there is
/// `F(d) sum_j s_j B_j(d)` and what is stored `sum_j s_j W_j(d)`, `W_j = integral of B_j F` and B_j the piecewise
/// linear functions that are 1 at kFeltPress_mm[j] and 0 at the others.
/// @par Source resources/docs/felt.md
struct FeltPress
{
    static constexpr std::size_t kCount = kFeltPress_mm.size();
    static constexpr auto kPerWidth = [] {
        std::array<double, kCount - 1> inverse{};
        for (std::size_t j = 0; j < inverse.size(); ++j) {
            inverse[j] = 1.0 / (kFeltPress_mm[j + 1] - kFeltPress_mm[j]);
        }
        return inverse;
    }(); ///< [1/mm]

    std::array<double, kCount> weights{};  ///< B_j(d) [1]
    std::array<double, kCount> energies{}; ///< W_j(d) [mJ]

    /// The weights alone, where what is stored is not asked for: `sum_j s_j B_j(d)` has two terms at most.
    /// @param at  gives s_j; @param depth_mm  d > 0
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
    /// @param depth_mm  d > 0; @param law  the structure's there
    /// @par Real-time Wait-free.
    [[nodiscard]] PALPATE_ALWAYS_INLINE static FeltPress at(const HapticStructure& on, double depth_mm,
                                                            const ForceTable::Value& law) noexcept
    {
        FeltPress press;
        double energy = 0.0, moment = 0.0; // of the law at `from`
        for (std::size_t j = 0; j + 1 < kCount && depth_mm > kFeltPress_mm[j]; ++j) {
            const double from = kFeltPress_mm[j], perWidth = kPerWidth[j];
            const bool endsHere = depth_mm <= kFeltPress_mm[j + 1];
            const double to = endsHere ? depth_mm : kFeltPress_mm[j + 1];
            const double energyTo = endsHere ? law.energy_mJ : on.lawAt(to).energy_mJ, momentTo = on.momentAt(to);
            // The integral of F times what rises from 0 to 1 between the two.
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
