// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/device/DevicePlugin.h"

#include <palpate/core/Export.h>

#include <string_view>

namespace palpate::device {

/// Plugin metadata, read without loading code.
struct PluginInfo
{
    std::string id;   ///< identifier for the command line and settings
    std::string name; ///< display name
    std::string version;
    std::string license; ///< SPDX
    std::string drives;  ///< description of the supported devices
    int apiVersion = 0;  ///< interface version declared by the author
};

/// File found in a plugin folder.
struct PluginEntry
{
    std::filesystem::path file;
    PluginInfo info;     ///< as far as readable
    core::Status status; ///< reason why the plugin is skipped; ok if no problem is known
};

/// Plugin folders in search order: `named` (from the command line), the user's folder, the program's folder. A relative
/// path in the environment variable of the user's folder is ignored, as required by the XDG base directory
/// specification: the result would depend on the working folder.
/// @param program  folder of the running program
[[nodiscard]] PALPATE_EXPORT std::vector<std::filesystem::path>
pluginFolders(const std::vector<std::filesystem::path>& named, const std::filesystem::path& program);

/// Folders with the user's device settings: Palpate's configuration folder, then the home folder; absolute paths only.
[[nodiscard]] PALPATE_EXPORT std::vector<std::filesystem::path> deviceSettingsFolders();

/// Finds, checks and loads device plugins. A faulty plugin never stops the program: the plugin is listed with the
/// reason and skipped. Loaded code stays loaded until the program ends. Use from one thread, not the servo thread;
/// destroy devices made by a plugin before the host.
class PALPATE_EXPORT PluginHost
{
  public:
    /// Reads the metadata of every .so file in `folders` without loading code. The first of several plugins with the
    /// same id wins. A plugin is skipped if another user could replace the file: the file, its folder and all parent
    /// folders must belong to root or to the user, and the file and its folder must not be writable by group or others.
    /// @param probe  command that runs `answerProbe` in a separate process on the plugin file, appended as the last
    /// argument, before the plugin is loaded here; empty: no probe, so a crashing plugin crashes the program
    /// @param probeTimeout_ms  time after which the plugin counts as hung; a healthy plugin takes a fraction of a
    /// second
    explicit PluginHost(const std::vector<std::filesystem::path>& folders, std::vector<std::string> probe = {},
                        int probeTimeout_ms = 10'000);
    PluginHost(const PluginHost&) = delete;
    PluginHost& operator=(const PluginHost&) = delete;

    [[nodiscard]] const std::vector<PluginEntry>& plugins() const noexcept { return m_plugins; }
    /// Loads the plugin and lists its connected devices. If loading fails, `plugins` shows the reason.
    core::Result<std::vector<FoundDevice>> find(std::string_view id);
    /// Loads the plugin and creates a device driver.
    core::Result<std::unique_ptr<HapticDevice>> make(std::string_view id, const std::string& address = {});

  private:
    core::Result<DevicePlugin*> load(std::string_view id);

    std::vector<std::string> m_probe;
    int m_probeTimeout_ms;
    std::vector<PluginEntry> m_plugins;
    std::vector<DevicePlugin*> m_loaded; ///< one for each entry; nullptr: not loaded
    std::mutex m_bus;
    PluginServices m_services;
};

/// Loads the plugin and lists its devices; `PluginHost` runs this probe in another process.
/// @return error of the plugin, unless the plugin ended the process
[[nodiscard]] PALPATE_EXPORT core::Status probePlugin(const std::filesystem::path& file);

/// Child process side of the probe: reads a random word from standard input before any code of the plugin runs, and
/// writes the word to standard output if the plugin works. The exit code alone proves nothing, because the plugin may
/// end the process with any code.
/// @return as probePlugin
[[nodiscard]] PALPATE_EXPORT core::Status answerProbe(const std::filesystem::path& file);

} // namespace palpate::device
