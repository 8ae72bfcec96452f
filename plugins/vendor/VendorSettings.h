// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hid/SettingsFile.h>
#include <palpate/core/Status.h>

#include <filesystem>
#include <vector>

namespace palpate::vendor {

/// Settings that every driver of a maker's library has; 0 means that the file has no such limit.
struct VendorSettings
{
    std::filesystem::path library; ///< path of the maker's library; empty: search
    double maxForce_N = 0.0;
    double maxStiffness_N_per_mm = 0.0;
    double maxDamping_Ns_per_mm = 0.0;
    double workspaceRadius_mm = 0.0;
};

/// Where these settings are, and the words of the error messages.
struct SettingsKind
{
    const char* file;    ///< "forcedimension.json"
    const char* example; ///< valid content
    const char* library; ///< "libdhd.so.3"
};

/// Reads library, max_force_N, max_stiffness_N_per_mm, max_damping_Ns_per_mm and workspace_radius_mm from the first
/// folder that contains the file.
/// @return the file, for further fields; Unreadable, BadFormat or OutOfRange with the place
[[nodiscard]] core::Result<hid::SettingsFile> readVendorSettings(const std::vector<std::filesystem::path>& folders,
                                                                 const SettingsKind& kind, VendorSettings& settings);

} // namespace palpate::vendor
