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

/// A contact with a structure that was taken out of the scene, so that the hand that stays finds it again.
struct LeftContact
{
    Vec3 p_WG = Vec3::Zero();    ///< god-object then [mm]
    Vec3 p_WH = Vec3::Zero();    ///< HIP then [mm]
    double age_s = 0.0;          ///< in ticks since then [s]
    std::uint64_t structure = 0; ///< a hash of its number and name
    std::uint8_t isKept = 0;     ///< 0: there is none, and the rest is without meaning
    std::uint8_t isOnSheet = 0;  ///< 1: with a surface without an inside
    std::uint8_t pad[6]{};
};

/// Everything that decides the coming ticks besides the scene and the HIP. Trivially copyable, so that a recording can
/// carry it and a replay can start from it bit for bit.
struct PalpatorState
{
    std::array<GodObjectState, HapticScene::kMaxLayers> layers{};
    std::array<LeftContact, HapticScene::kMaxLayers> left{};
    Vec3 p_WH = Vec3::Zero();  ///< HIP of the previous tick [mm]
    std::uint32_t started = 0; ///< 0 before the first tick
};

} // namespace palpate::haptics
