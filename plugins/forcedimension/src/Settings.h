// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::forcedimension {

/// Content of forcedimension.json; 0 means that the file has no such limit.
struct Settings
{
    std::filesystem::path library; ///< path of the maker's library; empty: search
    int serial = 0;                ///< serial number of the device to open; 0: the only one
    double maxForce_N = 0.0;
    double maxStiffness_N_per_mm = 0.0;
    double maxDamping_Ns_per_mm = 0.0;
    double workspaceRadius_mm = 0.0;
};

/// Reads forcedimension.json from the first folder that contains one: an object with any of library, serial,
/// max_force_N, max_stiffness_N_per_mm, max_damping_Ns_per_mm, workspace_radius_mm.
[[nodiscard]] core::Result<Settings> readSettings(const std::vector<std::filesystem::path>& folders);

} // namespace palpate::forcedimension
