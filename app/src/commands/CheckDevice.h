// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::app {

/// Options of `palpate devices --check`.
struct CheckOptions
{
    std::string device; ///< "simulated" or the id of a plugin
    std::filesystem::path out = "out/selftest";
    std::string rate = "1000";
};

/// Tests a device and writes the page. Ctrl+C removes the force and ends the test.
/// @return exit code: kSomeLost if not everything could be measured; kFailed, without a page, after a fault
[[nodiscard]] int checkDevice(const std::vector<std::filesystem::path>& pluginFolders, const CheckOptions& options);

} // namespace palpate::app
