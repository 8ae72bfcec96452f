// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "VendorSettings.h"

#include <palpate/core/Types.h>

#include <string_view>

namespace palpate::vendor {

/// Published limits of a model.
struct DeviceModel
{
    std::string_view name;
    double maxForce_N = 0.0;
    double maxStiffness_N_per_mm = 0.0;
    double maxDamping_Ns_per_mm = 0.0;
    double resolution_mm = 0.0; ///< 0: unknown
    double workspaceRadius_mm = 0.0;
    core::Vec3 centre_mm = core::Vec3::Zero(); ///< of the workspace, in the device's frame
    bool isKnown = false;                      ///< false: a type without published limits
};

/// Returns the model with the limits of a preset of `device::devicePresets`.
[[nodiscard]] DeviceModel presetModel(std::string_view preset, std::string_view name);

/// Applies the limits of the user's settings. Limits of a known model can only be lowered.
[[nodiscard]] DeviceModel limited(DeviceModel model, const VendorSettings& settings);

/// Lowers `limit` to a value that the device reports; a value that is not positive or not finite is ignored.
void lowerTo(double reported, double& limit) noexcept;

} // namespace palpate::vendor
