// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/device/HapticDevice.h"

#include <palpate/core/Export.h>

#include <span>
#include <string_view>

namespace palpate::device {

/// Nominal force limit of devices without motors [N]: keeps displayed forces finite and bounded. Equal to the largest
/// limit of the presets.
inline constexpr double kShownForceLimit_N = 20.0;

/// Mechanical properties of a device at the tip, without a hand. Low damping and friction are the critical case for
/// stability, so half of a manufacturer's "at most" value is used, and a low value where nothing is specified.
struct DeviceMechanics
{
    double mass_kg = 0.0;
    double damping_Ns_per_mm = 0.0; ///< viscous damping to the ground
    double friction_N = 0.0;        ///< Coulomb friction
    double resolution_mm = 0.0;     ///< position sensor resolution
};

/// Published limits of a device model, for the simulated device and for stiffness recommendations.
struct DevicePreset
{
    std::string_view id;   ///< identifier on the command line: "touch", "phantom-desktop", ...
    std::string_view name; ///< display name
    double maxForce_N = 0.0;
    double maxStiffness_N_per_mm = 0.0;
    double maxDamping_Ns_per_mm = 0.0;
    double workspaceRadius_mm = 0.0;
    DeviceMechanics mechanics;
};

/// All presets. Where manufacturers give a range (Touch), the lower and therefore safer value is used.
/// @par Source Limits: device table of CHAI3D 3.3, src/devices; WoodenHaptics: figures of that project; PHANToM (1995):
/// 18 N from Zilles & Salisbury, IROS 1995, all other values from its successor, the Premium 1.5. Mechanics:
/// docs/stability.md lists which values are specified by the manufacturer and which are assumed.
[[nodiscard]] PALPATE_EXPORT std::span<const DevicePreset> devicePresets() noexcept;

/// @return the preset with this id, or nullptr.
[[nodiscard]] PALPATE_EXPORT const DevicePreset* findDevicePreset(std::string_view id) noexcept;

/// Device description for a preset: three sensed and actuated axes, no buttons.
[[nodiscard]] PALPATE_EXPORT DeviceInfo deviceInfo(const DevicePreset& preset);

} // namespace palpate::device
