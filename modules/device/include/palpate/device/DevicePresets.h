// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/device/HapticDevice.h"

#include <span>
#include <string_view>

namespace palpate::device {

/// The largest force that a device without motors is said to take [N]: it is not felt, but every force that is shown
/// stays finite and bounded. The largest of the presets.
inline constexpr double kShownForceLimit_N = 20.0;

/// What a device's mechanics are like at the tip, without a hand. Little damping and friction is the hard case for
/// stability, so where a maker states "at most", half of that is taken, and where nothing is stated, little.
struct DeviceMechanics
{
    double mass_kg = 0.0;
    double damping_Ns_per_mm = 0.0; ///< viscous; a damper to the ground
    double friction_N = 0.0;        ///< Coulomb
    double resolution_mm = 0.0;     ///< step of the position sensor
};

/// Published limits of a kind of device, for the simulated one and for advice about stiffness.
struct DevicePreset
{
    std::string_view id;   ///< for command lines: "touch", "phantom-desktop", ...
    std::string_view name; ///< for a person
    double maxForce_N = 0.0;
    double maxStiffness_N_per_mm = 0.0;
    double maxDamping_Ns_per_mm = 0.0;
    double workspaceRadius_mm = 0.0;
    DeviceMechanics mechanics;
};

/// All presets. Where makers give a range (Touch), the smaller and so safer end.
/// @par Source Limits: the device table of CHAI3D 3.3, src/devices; for WoodenHaptics the project's own figures; for
/// PHANToM (1995) the 18 N of Zilles & Salisbury, IROS 1995, and all else from its successor, the Premium 1.5.
/// Mechanics: resources/docs/stability.md says of each number whether its maker states it or it is assumed.
[[nodiscard]] std::span<const DevicePreset> devicePresets() noexcept;

/// @return the preset called `id`, or null.
[[nodiscard]] const DevicePreset* findDevicePreset(std::string_view id) noexcept;

/// What a device of this kind says about itself: three sensed and driven axes, no buttons.
[[nodiscard]] DeviceInfo deviceInfo(const DevicePreset& preset);

} // namespace palpate::device
