// SPDX-License-Identifier: BSD-3-Clause
#include "Configurations.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>

namespace palpate::openhaptics {

namespace {

constexpr std::size_t kMostConfigurations = 8; // each is opened to list its device

} // namespace

std::filesystem::path configurationFolder()
{
    if (const char* const folder = std::getenv("GTDD_HOME"); folder != nullptr && folder[0] == '/') {
        return std::filesystem::path(folder) / "config";
    }
    const char* const home = std::getenv("HOME");
    return std::filesystem::path(home == nullptr ? "/" : home) / ".3dsystems" / "config";
}

std::vector<std::string> configuredDevices()
{
    std::vector<std::string> names;
    std::error_code error;
    for (std::filesystem::directory_iterator it(configurationFolder(), error), end; !error && it != end;
         it.increment(error)) {
        if (it->path().extension() == ".config") {
            names.push_back(it->path().stem().string());
        }
    }
    std::sort(names.begin(), names.end());
    names.resize(std::min(names.size(), kMostConfigurations));
    return names;
}

std::string defaultOf(const std::vector<std::string>& names)
{
    for (const char* const name : {"Default Device", "Default PHANToM"}) {
        if (std::find(names.begin(), names.end(), name) != names.end()) {
            return name;
        }
    }
    return names.size() == 1 ? names.front() : "";
}

} // namespace palpate::openhaptics
