// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Settings.h"

#include <palpate/core/Types.h>

#include <string>
#include <string_view>

namespace palpate::haply {

/// Limits of a model. The Inverse Service reports none.
struct Model
{
    std::string name;
    double maxForce_N = 0.0;
    double maxStiffness_N_per_mm = 0.0;
    double maxDamping_Ns_per_mm = 0.0;
    double workspaceRadius_mm = 0.0;
    core::Vec3 centre_m = core::Vec3::Zero(); ///< of the workspace, from the mounting plate, in the service's axes
    bool isKnown = false;                     ///< false: a model without published limits
};

/// Returns the limits of a model. A model without published limits (Minverse, newer ones) gets cautious ones; its
/// centre is not known either, so that the service must put the origin there.
/// @param type  as reported by the service: "inverse3", "inverse3x", "minverse"; empty: an Inverse3
/// @par Source Limits and centre of the Inverse3: the maker's fork of CHAI3D (HaplyHaptics/chai3d, CHaplyDevices.cpp)
[[nodiscard]] Model modelOf(std::string_view type);

/// Applies the limits of the user's settings. Published limits can only be lowered.
[[nodiscard]] Model limited(Model model, const Settings& settings);

} // namespace palpate::haply
