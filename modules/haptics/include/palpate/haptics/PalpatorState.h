// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/HapticScene.h"

#include <array>
#include <cstdint>

namespace palpate::haptics {

/// A god-object between ticks: its position and what it touches.
struct GodObjectState
{
    Vec3 p_WG = Vec3::Zero(); ///< [mm]
    std::array<std::uint32_t, 3> structure{};
    std::array<std::uint32_t, 3> triangle{};
    std::array<std::int8_t, 3> side{}; ///< +1: on the front of the triangle, -1: behind it
    std::uint8_t constraints = 0;      ///< how many of the three are valid
    std::uint8_t placed = 0;           ///< 0: the next step starts at its HIP
    std::uint8_t slides = 0;           ///< 1: friction let go of it, and has not caught it again
    std::uint8_t pad[2]{};
};

/// Everything that decides the coming ticks besides the scene and the HIP. Trivially copyable, so that a recording can
/// carry it and a replay can start from it bit for bit.
struct PalpatorState
{
    std::array<GodObjectState, HapticScene::kMaxLayers> layers{};
    Vec3 p_WH = Vec3::Zero();  ///< HIP of the previous tick [mm]
    std::uint32_t started = 0; ///< 0 before the first tick
};

} // namespace palpate::haptics
