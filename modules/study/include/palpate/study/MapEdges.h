// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Types.h>
#include <palpate/device/DevicePresets.h>
#include <palpate/haptics/HapticScene.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace palpate::study {

/// Model of the hand that holds a device: a mass at the tip, and a spring and a damper to the intended position.
struct Grip
{
    std::string name;
    double mass_kg = 0.0;
    double stiffness_N_per_mm = 0.0;
    double damping_Ns_per_mm = 0.0;
};

/// Grips used to evaluate a device. The light grip is the worst case with little mass and little damping (0.16 of
/// critical on a Touch); its values are an assumption below published ones. "a fingertip" is the middle of the range
/// measured at low force by Hajian & Howe, J. Biomech. Eng. 119 (1997) 109, doi:10.1115/1.2796052.
[[nodiscard]] PALPATE_EXPORT const std::vector<Grip>& grips();

/// Returns the force of a resting hand [N]: 3 N, limited to 40 % of the device's maximum.
[[nodiscard]] PALPATE_EXPORT double restingPush_N(double maxForce_N) noexcept;

/// Properties of a device and its control loop that determine the oscillation of the tip.
struct HeldDevice
{
    device::DeviceMechanics mechanics; ///< of the device alone
    double added_Ns_per_mm = 0.0;      ///< guaranteed damping by the passivity controller
    double delay_s = 0.0;              ///< delay from a motion to the resulting force, including half a period
    double push_N = 0.0;               ///< force of the resting hand
    double scale = 1.0;                ///< mm of the scene per mm of the device
};
/// @param delayTicks  delay of the force after the tick that computed it
[[nodiscard]] PALPATE_EXPORT HeldDevice heldDevice(const device::DevicePreset& preset, double rate_Hz, int delayTicks);
/// Creates the same from the description of a device. Uses the mechanics of the preset with the same id. Unknown
/// properties get the most unfavourable values: no friction and no damping in the device.
/// @param scale  mm of the scene per mm of the device
/// @return empty for a device without motors, which cannot sustain an oscillation
[[nodiscard]] PALPATE_EXPORT std::optional<HeldDevice> heldDevice(const device::DeviceInfo& info, double rate_Hz,
                                                                  int delayTicks, double scale = 1.0);

/// Smallest peak-to-peak oscillation of the tip that is reported [mm of the device].
inline constexpr double kMinSwing_mm = 0.05;

/// Mesh edge where the slope of a structure's map changes most for a device: from flat to rising or from rising to
/// steeper.
struct MapEdge
{
    std::size_t structure = 0;
    core::Vec3 p_W = core::Vec3::Zero(); ///< midpoint of the edge [mm]
    double jump_N = 0.0;                 ///< jump of the tangential force at the edge, with a resting hand
    /// Peak-to-peak oscillation of the tip around the edge that the device may be unable to damp [mm of the device].
    double swing_mm = 0.0;
    bool isOfLumps = false; ///< caused mostly by buried lumps, not by the stiffness map
};

/// Finds the map edges that can make a device oscillate. The gradient of a map pushes the tip sideways until the tip
/// rests at the edge where the gradient begins. There the force is switched with a delay, like a relay in the loop, and
/// sustains an oscillation even on soft tissue. Below kMinSwing_mm the tip rests. The force is `W grad s` for a
/// stiffness map, `s sum_j W_j grad s_j` for buried lumps (haptics/FeltPress.h), and their sum for both. A map with
/// values per triangle has steps but no gradient, so there is no such force. Tissue friction removes the force and thus
/// the oscillation.
/// @return for each structure with such an edge the worst edge over both grips
/// @par Cost O(triangles). Any thread.
/// @par Source docs/stability.md, "A map's edges": describing function of a relay, with the damping, friction
///             and mass of device and hand.
[[nodiscard]] PALPATE_EXPORT std::vector<MapEdge> mapEdges(const haptics::HapticScene& scene, const HeldDevice& device);

} // namespace palpate::study
