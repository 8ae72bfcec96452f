// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>
#include <vendor/VendorSettings.h>

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::openhaptics {

/// Content of openhaptics.json.
struct Settings : vendor::VendorSettings
{
    std::string device; ///< name of a configuration or serial number; empty: the default device
};

/// Reads openhaptics.json from the first folder that contains one: an object with any of library, device, max_force_N,
/// max_stiffness_N_per_mm, max_damping_Ns_per_mm, workspace_radius_mm.
[[nodiscard]] core::Result<Settings> readSettings(const std::vector<std::filesystem::path>& folders);

} // namespace palpate::openhaptics
