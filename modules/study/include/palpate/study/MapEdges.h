// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>
#include <palpate/device/DevicePresets.h>
#include <palpate/haptics/HapticScene.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace palpate::study {

/// How a hand holds a device: a mass on the tip, a spring and a damper to where it wants to be.
struct Grip
{
    std::string name;
    double mass_kg = 0.0;
    double stiffness_N_per_mm = 0.0;
    double damping_Ns_per_mm = 0.0;
};

/// The two grips that a device is judged with. The light one is the hard case: little mass, little damping (0.16 of
/// critical on a Touch). It is a choice below what is published; "a fingertip" is of the middle of what Hajian & Howe
/// measured at low force, J. Biomech. Eng. 119 (1997) 109, doi:10.1115/1.2796052.
[[nodiscard]] const std::vector<Grip>& grips();

/// A hand's push when it rests [N]: 3 N, or 40 % of what the device can.
[[nodiscard]] double restingPush_N(double maxForce_N) noexcept;

/// A device in its loop, as far as it counts for how far a tip swings.
struct HeldDevice
{
    device::DeviceMechanics mechanics; ///< without a hand
    double added_Ns_per_mm = 0.0;      ///< damping that the passivity controller is sure to add
    double delay_s = 0.0;              ///< from a motion to the force that answers it, half a period with it
    double push_N = 0.0;               ///< of the hand that rests
    double scale = 1.0;                ///< mm of the scene for a mm of the device
};
/// @param delayTicks  after the tick that computed it, a force acts so many ticks late
[[nodiscard]] HeldDevice heldDevice(const device::DevicePreset& preset, double rate_Hz, int delayTicks);
/// The same of a device by what it says of itself: its mechanics are its preset's where there is one of its id; else
/// of what it doesn't say the least is taken, no friction and no damping of its own.
/// @param scale  mm of the scene for a mm of the device
/// @return nothing for a device without motors, which nothing can keep swinging
[[nodiscard]] std::optional<HeldDevice> heldDevice(const device::DeviceInfo& info, double rate_Hz, int delayTicks,
                                                   double scale = 1.0);

/// A swing of the tip from which on it counts as one, peak to peak. [mm of the device]
inline constexpr double kLeastSwing_mm = 0.05;

/// Where the maps of a structure bend most for a device: at an edge of its triangles, from flat to rising or from
/// rising to steeper.
struct MapEdge
{
    std::size_t structure = 0;
    core::Vec3 p_W = core::Vec3::Zero(); ///< middle of the edge [mm]
    double jump_N = 0.0;                 ///< by which the push aside jumps there, with a hand that rests there
    /// Of the tip about it, that the device can't be sure to damp, peak to peak [mm of the device].
    double swing_mm = 0.0;
    bool isOfLumps = false; ///< most of the jump is by lumps felt below, not by the map of stiffness
};

/// A tip that a map pushes aside comes to rest where that push begins, and the push switched on and off late is a relay
/// in the loop: it keeps the tip swinging, however soft the tissue. Where the swing is below kLeastSwing_mm the tip
/// rests. The push is `W grad s` of a map of stiffness, `s sum_j W_j grad s_j` of lumps felt below
/// (haptics/FeltPress.h) and both together where there are both. A map of a number per triangle has no gradient, so no
/// push: it steps, and a hand that rests on the step stays at rest. Friction of the tissue takes the push, and so all
/// of this, away.
/// @return for each structure that has such an edge the one with the largest swing over both grips
/// @par Cost O(triangles). Any thread.
/// @par Source resources/docs/stability.md, "A map's edges": the relay's describing function against the damping, the
///             friction and the mass of device and hand.
[[nodiscard]] std::vector<MapEdge> mapEdges(const haptics::HapticScene& scene, const HeldDevice& device);

} // namespace palpate::study
