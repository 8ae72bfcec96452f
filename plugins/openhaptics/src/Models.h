// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Settings.h"

#include <palpate/core/Types.h>
#include <vendor/DeviceModel.h>

#include <string>

namespace palpate::openhaptics {

/// Statements of a device about itself; a missing number is NaN.
struct Statement
{
    std::string model;  ///< "Touch"
    std::string serial; ///< empty: unknown
    double maxForce_N = 0.0;
    double continuousForce_N = 0.0;
    double maxStiffness_N_per_mm = 0.0;
    double maxDamping_Ns_per_mm = 0.0;
    core::Vec3 least_mm = core::Vec3::Zero(); ///< corners of the usable workspace, in the device's frame
    core::Vec3 most_mm = core::Vec3::Zero();
    unsigned calibrationStyles = 0; ///< bits of HdCalibrationStyle
};

/// Limits that hold for a device.
struct Limits : vendor::DeviceModel
{
    double continuousForce_N = 0.0; ///< while the motors are warm
};

/// Returns the limits: the published ones of the model, lowered by what the device states and by the settings. Of a
/// model without published limits those that the device states hold, up to 20 N; without any, cautious ones.
/// @par Source Published limits: device table of CHAI3D, as in `device::devicePresets`; Touch X is the successor
/// of the Phantom Desktop.
[[nodiscard]] Limits limitsOf(const Statement& statement, const Settings& settings);

} // namespace palpate::openhaptics
