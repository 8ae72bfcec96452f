// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/Stability.h"

#include <palpate/device/HandScript.h>
#include <palpate/servo/TickRecord.h>

#include <functional>
#include <vector>

namespace palpate::evaluation::stability {

/// A hand begins this far off the surface. [mm]
inline constexpr double kClearance_mm = 5.0;

/// A hand's push when it rests [N]: 3 N, or 40 % of what the device can.
[[nodiscard]] double push_N(const device::DevicePreset& preset);

/// The shape's structures with this stiffness, as the servo touches them.
[[nodiscard]] std::shared_ptr<const haptics::HapticScene> sceneOf(const Shape& shape, double stiffness_N_per_mm,
                                                                  double damping_Ns_per_mm);

/// Closes the loop over a hand's script, one servo tick after the other.
/// @param each  gets every tick, with the tip's true place
void closeLoop(const haptics::HapticScene& scene, const std::vector<device::HandTarget>& script, const Grip& grip,
               const Setup& setup, const std::function<void(const servo::TickRecord&, const Vec3& tip_W)>& each);

} // namespace palpate::evaluation::stability
