// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/Stability.h"

#include <palpate/device/HandScript.h>
#include <palpate/servo/TickRecord.h>

#include <functional>
#include <vector>

namespace palpate::evaluation::stability {

/// Initial distance of the hand from the surface. [mm]
inline constexpr double kClearance_mm = 5.0;

/// Force of a resting hand [N]: 3 N, or 40 % of the device's maximum if lower.
[[nodiscard]] double push_N(const device::DevicePreset& preset);

/// Scene with the structures of the shape at the given stiffness and damping, ready for the servo.
[[nodiscard]] std::shared_ptr<const haptics::HapticScene> sceneOf(const Shape& shape, double stiffness_N_per_mm,
                                                                  double damping_Ns_per_mm);

/// Runs the closed loop over a hand script, one servo tick at a time.
/// @param each  called for every tick with the true position of the tip
void closeLoop(const haptics::HapticScene& scene, const std::vector<device::HandTarget>& script, const Grip& grip,
               const Setup& setup, const std::function<void(const servo::TickRecord&, const Vec3& tip_W)>& each);

} // namespace palpate::evaluation::stability
