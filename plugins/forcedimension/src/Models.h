// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Settings.h"

#include <palpate/core/Types.h>

#include <string_view>

namespace palpate::forcedimension {

/// Published limits of a model.
struct Model
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

/// Returns the model of a system type of the maker's library. A type without published limits gets cautious ones, so
/// that a new model works at once, weakly.
/// @par Source Types: dhdc.h of the SDK 3.7 and the bindings for 3.16. Limits: device table of CHAI3D
/// (CDeltaDevices.cpp); resolutions as in `device::devicePresets`.
[[nodiscard]] Model modelOf(int systemType);

/// Applies the limits of the user's settings. Published limits can only be lowered.
/// @param reportedForce_N  the device's own force limit; not positive or not finite: unknown
[[nodiscard]] Model limited(Model model, const Settings& settings, double reportedForce_N);

} // namespace palpate::forcedimension
