// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>
#include <vendor/VendorSettings.h>

#include <filesystem>
#include <vector>

namespace palpate::forcedimension {

/// Content of forcedimension.json.
struct Settings : vendor::VendorSettings
{
    int serial = 0; ///< serial number of the device to open; 0: the only one
};

/// Reads forcedimension.json from the first folder that contains one: an object with any of library, serial,
/// max_force_N, max_stiffness_N_per_mm, max_damping_Ns_per_mm, workspace_radius_mm.
[[nodiscard]] core::Result<Settings> readSettings(const std::vector<std::filesystem::path>& folders);

} // namespace palpate::forcedimension
