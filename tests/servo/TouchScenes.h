// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/haptics/HapticScene.h>
#include <palpate/servo/SafetyGate.h>
#include <palpate/servo/TickRecord.h>

#include <memory>
#include <vector>

namespace palpate::test {

/// A scene with one icosphere of 5,120 triangles about `centre`, front side outwards.
std::shared_ptr<const haptics::HapticScene> sphereScene(double radius_mm, double stiffness_N_per_mm,
                                                        double damping_Ns_per_mm = 0.0,
                                                        const core::Vec3& centre = core::Vec3::Zero());

/// A motion over a sphere of radius 30 mm: down into it, around it under pressure, through free space and back; a HIP a
/// tick at 1 kHz, at most 0.4 mm apart.
std::vector<core::Vec3> palpatingMotion(int ticks);

/// Limits of the gate for a device of a preset, anywhere in space.
servo::GateLimits limitsOf(const char* preset);

/// The same bits in everything that a replay gives back.
bool isSameTick(const servo::TickRecord& a, const servo::TickRecord& b) noexcept;

} // namespace palpate::test
