// SPDX-License-Identifier: BSD-3-Clause
// palpate devices: lists available and connected haptic devices, or tests one.
#include "commands/CheckDevice.h"
#include "commands/Commands.h"
#include "shared/Console.h"
#include "shared/Devices.h"

#include <palpate/device/OtherDevices.h>

#include <CLI/CLI.hpp>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace palpate::app {

namespace {

int listDevices(const std::vector<std::filesystem::path>& folders)
{
    if (const core::Status status = checkPluginFolders(folders); !status.isOk()) {
        return report(status);
    }
    const auto host = findPlugins(folders);
    print("built in\n"
          "  mouse      the pointer over the view; it feels nothing\n"
          "  simulated  a simulated hand on a simulated device\n"
          "  playback   a recorded or written motion\n"
          "plugins\n");
    // Loading a plugin may mark the plugin as skipped, so ids are collected first.
    std::vector<std::string> ids;
    for (const device::PluginEntry& entry : host->plugins()) {
        if (entry.status.isOk()) {
            ids.push_back(entry.info.id);
        }
    }
    std::set<std::string> driving; // ids of plugins that found a usable device
    for (const std::string& id : ids) {
        const auto found = host->find(id);
        for (const device::PluginEntry& entry : host->plugins()) {
            if (!entry.status.isOk() || entry.info.id != id) {
                continue;
            }
            print("  %s %s (%s): %s\n    %s\n", id.c_str(), entry.info.version.c_str(), entry.info.license.c_str(),
                  entry.info.drives.c_str(), entry.file.c_str());
            if (found.isOk() && found.value().empty()) {
                print("    none on the bus\n");
            }
        }
        if (found.isOk()) {
            for (const device::FoundDevice& one : found.value()) {
                print("    on the bus: %s (%s)%s%s\n", one.name.c_str(), one.address.c_str(),
                      one.problem.empty() ? "" : "; ", one.problem.c_str());
                if (one.problem.empty()) {
                    driving.insert(id);
                }
            }
        }
    }
    if (ids.empty()) {
        print("  none\n");
    }
    auto others = device::recogniseOtherDevices();
    std::erase_if(others, [&](const device::OtherDevice& other) { return driving.contains(other.plugin); });
    if (!others.empty()) {
        print("on the bus, but not driven\n");
        for (const device::OtherDevice& other : others) {
            print("  %s: it would need %s\n", other.name.c_str(), other.needs.c_str());
        }
    }
    int code = kDone;
    for (const device::PluginEntry& entry : host->plugins()) {
        if (!entry.status.isOk()) {
            printError(entry.status.text());
            code = kSomeLost;
        }
    }
    return code;
}

} // namespace

void addDevicesCommand(CLI::App& app, Chosen& chosen)
{
    auto* command =
        app.add_subcommand("devices", "List devices to touch with: built-in ones, plugins, what is plugged in");
    auto folders = std::make_shared<std::vector<std::filesystem::path>>();
    command->add_option("--plugin-path", *folders, "Folder to look for device plugins in first; may be given again")
        ->allow_extra_args(false);
    auto check = std::make_shared<CheckOptions>();
    auto* name =
        command->add_option("--check", check->device,
                            "Test this device for a minute: round trip, friction, held stiffness; simulated or a "
                            "plugin's id");
    command->add_option("--out", check->out, "Folder for selftest.html and selftest.json")
        ->capture_default_str()
        ->needs(name);
    command->add_option("--rate", check->rate, "Servo rate of the test [Hz]")->capture_default_str()->needs(name);
    command->callback([folders, check, &chosen] {
        chosen = [folders, check] {
            return check->device.empty() ? listDevices(*folders) : checkDevice(*folders, *check);
        };
    });
}

} // namespace palpate::app
