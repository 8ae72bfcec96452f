// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/device/PluginHost.h>

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

namespace palpate::app {

/// The device plugins of this program: folders named on the command line, the user's, and those beside the program.
/// Each is tried in another process of this program before it is loaded.
[[nodiscard]] std::unique_ptr<device::PluginHost> findPlugins(const std::vector<std::filesystem::path>& named);

/// The word that makes this program such a trial: `palpate probe-plugin FILE`. Not for people.
inline constexpr std::string_view kProbeWord = "probe-plugin";
/// Runs the trial. @return exit code
[[nodiscard]] int probe(const char* file);

/// Refuses a plugin folder that is not there.
[[nodiscard]] core::Status checkPluginFolders(const std::vector<std::filesystem::path>& named);

} // namespace palpate::app
