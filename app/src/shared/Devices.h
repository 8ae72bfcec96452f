// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/device/PluginHost.h>

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

namespace palpate::app {

/// Makes the host of device plugins: folders from the command line, the user's folder, and folders beside the
/// program. Each plugin is probed in a separate process of this program before loading.
[[nodiscard]] std::unique_ptr<device::PluginHost> findPlugins(const std::vector<std::filesystem::path>& named);

/// First argument of such a probe process: `palpate probe-plugin FILE`. For internal use.
inline constexpr std::string_view kProbeWord = "probe-plugin";
/// Runs the probe. @return exit code
[[nodiscard]] int probe(const char* file);

/// Returns an error for a plugin folder that does not exist.
[[nodiscard]] core::Status checkPluginFolders(const std::vector<std::filesystem::path>& named);

} // namespace palpate::app
