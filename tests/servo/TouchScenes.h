// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/haptics/HapticScene.h>
#include <palpate/servo/SafetyGate.h>
#include <palpate/servo/TickRecord.h>

#include <memory>
#include <vector>

namespace palpate::test {

/// Returns a scene with one icosphere of 5,120 triangles about `centre`, front side outwards.
/// @param fingertip_mm  radius of the probe
std::shared_ptr<const haptics::HapticScene> sphereScene(double radius_mm, double stiffness_N_per_mm,
                                                        double damping_Ns_per_mm = 0.0,
                                                        const core::Vec3& centre = core::Vec3::Zero(),
                                                        double fingertip_mm = 0.0);

/// Returns a motion over a sphere of radius 30 mm: down into the sphere, around under pressure, through free space and
/// back; one HIP per tick at 1 kHz, at most 0.4 mm apart.
std::vector<core::Vec3> palpatingMotion(int ticks);

/// Returns the gate's limits for the device of a preset, for any position of the hand.
servo::GateLimits limitsOf(const char* preset);

/// Compares all replayed data of two ticks bit for bit.
bool isSameTick(const servo::TickRecord& a, const servo::TickRecord& b) noexcept;

} // namespace palpate::test
