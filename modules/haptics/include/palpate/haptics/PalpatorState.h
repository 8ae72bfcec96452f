// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/HapticScene.h"

#include <array>
#include <cstdint>

namespace palpate::haptics {

/// Persistent state of a god-object between ticks: position and active contacts.
struct GodObjectState
{
    Vec3 p_WG = Vec3::Zero(); ///< position [mm], world frame; in moving tissue its rest shape
    std::array<std::uint32_t, 3> structure{};
    std::array<std::uint32_t, 3> triangle{};
    std::array<std::int8_t, 3> side{}; ///< +1: on the front of the triangle, -1: on the back
    std::uint8_t constraints = 0;      ///< number of valid entries in the three arrays
    std::uint8_t placed = 0;           ///< kNotPlaced, kPlaced or kTight
    std::uint8_t slides = 0;           ///< 1: sliding; friction released the god-object and has not caught it since
    std::uint8_t pad[2]{};

    static constexpr std::uint8_t kNotPlaced = 0; ///< the next tick starts at the HIP
    static constexpr std::uint8_t kPlaced = 1;
    /// Placed without regard to the surfaces, by a start at the HIP or a change of scene: a ball may be nearer to a
    /// surface than its radius, or inside. It then keeps its distance instead of its radius, until the whole ball fits.
    static constexpr std::uint8_t kTight = 2;
};

/// A contact with a structure that was removed from the scene. Allows a hand that stays in place to resume the contact
/// when the structure returns.
struct LostContact
{
    Vec3 p_WG = Vec3::Zero();    ///< god-object position at removal [mm]
    Vec3 p_WH = Vec3::Zero();    ///< HIP at removal, of a moving structure in its rest shape [mm]
    double age_s = 0.0;          ///< time since removal, counted in ticks [s]
    std::uint64_t structure = 0; ///< hash of the structure's index and name
    std::uint8_t isKept = 0;     ///< 0: empty, all other members are meaningless
    std::uint8_t isOnSheet = 0;  ///< 1: the contact was on an open surface, touched from both sides
    std::uint8_t pad[6]{};
};

/// Complete state of a Palpator between ticks: together with the scene and the HIP, this determines all following
/// ticks. Trivially copyable, so that a recording can store the state and a replay can start from it bit for bit.
struct PalpatorState
{
    std::array<GodObjectState, HapticScene::kMaxLayers> layers{};
    std::array<LostContact, HapticScene::kMaxLayers> left{};
    /// HIP of the previous tick in the rest shape of each layer [mm]; zero in a scene at rest.
    std::array<Vec3, HapticScene::kMaxLayers> p_RH = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    Vec3 p_WH = Vec3::Zero();  ///< HIP of the previous tick [mm]
    std::uint32_t started = 0; ///< 0 before the first tick
};

} // namespace palpate::haptics
