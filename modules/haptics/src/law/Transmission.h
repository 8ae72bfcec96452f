// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "law/MapSample.h"
#include "palpate/haptics/FeltPress.h"

#include <palpate/core/Realtime.h>

#include <cstddef>

namespace palpate::haptics::law {

/// Effect of buried lumps on a surface's law: `U = sum_j s_j(x) W_j(d)`, with s_j the transmission maps at the foot x
/// and W_j as in FeltPress. The force is `F(d)` times the maps interpolated between two penetration depths, and derives
/// from a single energy.
/// @par Source resources/docs/felt.md
struct Transmission
{
    double scale = 0.0;           ///< sum of s_j B_j(d) [1]
    double energy_mJ = 0.0;       ///< sum of s_j W_j(d)
    Vec3 gradient = Vec3::Zero(); ///< sum of W_j(d) grad s_j [N]

    /// Computes only `scale`, bitwise identical.
    /// @param depth_mm  d > 0
    /// @par Real-time Wait-free.
    [[nodiscard]] PALPATE_ALWAYS_INLINE static double scaleAt(const MapPlace& place, const HapticStructure& on,
                                                              double depth_mm) noexcept
    {
        return FeltPress::scaleAt(depth_mm, [&](std::size_t j) { return place.numberOf(on.maps.felt[j]); });
    }
    /// Computes all members.
    /// @param place  position of the foot
    /// @param depth_mm  d > 0
    /// @param law  value of the structure's law at `depth_mm`
    /// @par Real-time Wait-free.
    [[nodiscard]] PALPATE_ALWAYS_INLINE static Transmission at(const MapPlace& place, const HapticStructure& on,
                                                               double depth_mm, const ForceTable::Value& law) noexcept
    {
        constexpr std::size_t kCount = FeltPress::kCount;
        const FeltPress press = FeltPress::at(on, depth_mm, law);
        Transmission felt;
        double toSecond = 0.0, toThird = 0.0;
        for (std::size_t j = 0; j < kCount && (j == 0 || depth_mm > kFeltPress_mm[j - 1]); ++j) {
            const MapPlace::Rises s = place.risesOf(on.maps.felt[j]);
            felt.scale += press.weights[j] * s.value;
            felt.energy_mJ += press.energies[j] * s.value;
            toSecond += press.energies[j] * s.toSecond;
            toThird += press.energies[j] * s.toThird;
        }
        felt.gradient = place.slopes().gradientOf(toSecond, toThird);
        return felt;
    }
};

} // namespace palpate::haptics::law
