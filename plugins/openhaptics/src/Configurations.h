// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::openhaptics {

/// Folder with the configurations that the maker's setup program writes, one file for each device: config in
/// GTDD_HOME, or in .3dsystems in the home folder.
[[nodiscard]] std::filesystem::path configurationFolder();

/// Names of the configured devices, sorted: "Default Device". The library opens devices by these names and cannot list
/// the devices that are connected.
[[nodiscard]] std::vector<std::string> configuredDevices();

/// Returns the name of the device that programs of the maker use by default; the name differs between versions.
/// @return empty: there is no such configuration
[[nodiscard]] std::string defaultOf(const std::vector<std::string>& names);

} // namespace palpate::openhaptics
