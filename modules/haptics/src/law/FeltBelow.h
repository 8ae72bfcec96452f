// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "law/MapValue.h"

#include <palpate/core/Realtime.h>

#include <array>
#include <cstddef>

namespace palpate::haptics::law {

/// What lumps below a surface make of its law: `U = sum_j s_j(x) W_j(d)` with s_j the felt maps at the foot x and
/// `W_j = integral of B_j F`, B_j the piecewise linear functions that are 1 at kFeltPress_mm[j] and 0 at the others.
/// So the force is `F(d)` times what the maps say between two presses, and there is one energy.
/// @par Source resources/docs/felt.md
struct FeltBelow
{
    double scale = 0.0;           ///< sum of s_j B_j(d) [1]
    double energy_mJ = 0.0;       ///< sum of s_j W_j(d)
    Vec3 gradient = Vec3::Zero(); ///< sum of W_j(d) grad s_j [N]

    /// @param place  of the foot; @param depth_mm  d > 0; @param law  the structure's there
    /// @par Real-time Wait-free.
    [[nodiscard]] PALPATE_ALWAYS_INLINE static FeltBelow at(const MapPlace& place, const HapticStructure& on,
                                                            double depth_mm, const ForceTable::Value& law) noexcept
    {
        constexpr std::size_t kCount = kFeltPress_mm.size();
        constexpr auto kPerWidth = [] {
            std::array<double, kCount - 1> inverse{};
            for (std::size_t j = 0; j < inverse.size(); ++j) {
                inverse[j] = 1.0 / (kFeltPress_mm[j + 1] - kFeltPress_mm[j]);
            }
            return inverse;
        }();
        std::array<double, kCount> weights{}, energies{}; // B_j(d), W_j(d)
        double energy = 0.0, moment = 0.0;                // of the law at `from`
        for (std::size_t j = 0; j + 1 < kCount && depth_mm > kFeltPress_mm[j]; ++j) {
            const double from = kFeltPress_mm[j], perWidth = kPerWidth[j];
            const bool endsHere = depth_mm <= kFeltPress_mm[j + 1];
            const double to = endsHere ? depth_mm : kFeltPress_mm[j + 1];
            const double energyTo = endsHere ? law.energy_mJ : on.lawAt(to).energy_mJ, momentTo = on.momentAt(to);
            // The integral of F times what rises from 0 to 1 between the two.
            const double rising = (momentTo - moment - from * (energyTo - energy)) * perWidth;
            energies[j] += energyTo - energy - rising;
            energies[j + 1] += rising;
            if (endsHere) {
                weights[j + 1] = (depth_mm - from) * perWidth;
                weights[j] = 1.0 - weights[j + 1];
            }
            energy = energyTo;
            moment = momentTo;
        }
        if (depth_mm > kFeltPress_mm.back()) {
            weights.back() = 1.0;
            energies.back() += law.energy_mJ - energy;
        }
        FeltBelow felt;
        double toSecond = 0.0, toThird = 0.0;
        for (std::size_t j = 0; j < kCount && (j == 0 || depth_mm > kFeltPress_mm[j - 1]); ++j) {
            const MapPlace::Rises s = place.risesOf(on.maps.felt[j]);
            felt.scale += weights[j] * s.value;
            felt.energy_mJ += energies[j] * s.value;
            toSecond += energies[j] * s.toSecond;
            toThird += energies[j] * s.toThird;
        }
        felt.gradient = place.slopes().gradientOf(toSecond, toThird);
        return felt;
    }
};

} // namespace palpate::haptics::law
