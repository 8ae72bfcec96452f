// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/device/DevicePlugin.h"

#include <string_view>

namespace palpate::device {

/// What a plugin says about itself, read without loading its code.
struct PluginInfo
{
    std::string id;   ///< for command lines and settings
    std::string name; ///< for a person
    std::string version;
    std::string license; ///< SPDX
    std::string drives;  ///< which devices, in words
    int apiVersion = 0;  ///< that its author states
};

/// A file that was found where plugins are.
struct PluginEntry
{
    std::filesystem::path file;
    PluginInfo info;     ///< as far as it could be read
    core::Status status; ///< why it is skipped; ok: usable as far as is known
};

/// Where plugins are looked for, in this order: `named` (from the command line), the user's folder, beside the program.
/// A user's folder that the environment gives as a relative path is ignored, as the XDG base directory specification
/// asks: it would depend on the working folder.
/// @param program  folder of the running program
[[nodiscard]] std::vector<std::filesystem::path> pluginFolders(const std::vector<std::filesystem::path>& named,
                                                               const std::filesystem::path& program);

/// Where the user's settings of devices are: the configuration folder's Palpate, then home; absolute paths alone.
[[nodiscard]] std::vector<std::filesystem::path> deviceSettingsFolders();

/// Finds, checks and loads device plugins. A bad one never stops the program: it is named with the reason and skipped.
/// Loaded code stays loaded until the program ends. One thread, not the servo thread; devices made by a plugin must be
/// gone before the host.
class PluginHost
{
  public:
    /// Reads the metadata of every file in `folders` whose name ends in .so; loads nothing. Of two plugins with the
    /// same id the first one counts. A plugin is skipped when another user could replace it: the file, its folder and
    /// the folders above must belong to root or to the user, and group and others may not write to the first two.
    /// @param probe  command to which a plugin's file is appended, and that runs `answerProbe` on it in a process of
    ///               its own before it is loaded here; empty: no trial, a plugin that crashes takes the program down
    /// @param probeTimeout_ms  longer, and the plugin counts as hung; a healthy one takes a fraction of a second
    explicit PluginHost(const std::vector<std::filesystem::path>& folders, std::vector<std::string> probe = {},
                        int probeTimeout_ms = 10'000);
    PluginHost(const PluginHost&) = delete;
    PluginHost& operator=(const PluginHost&) = delete;

    [[nodiscard]] const std::vector<PluginEntry>& plugins() const noexcept { return m_plugins; }
    /// Devices on the bus that the plugin drives; loads it. A plugin that cannot be loaded is marked so in `plugins`.
    core::Result<std::vector<FoundDevice>> find(std::string_view id);
    /// Makes the driver of a device; loads the plugin.
    core::Result<std::unique_ptr<HapticDevice>> make(std::string_view id, const std::string& address = {});

  private:
    core::Result<DevicePlugin*> load(std::string_view id);

    std::vector<std::string> m_probe;
    int m_probeTimeout_ms;
    std::vector<PluginEntry> m_plugins;
    std::vector<DevicePlugin*> m_loaded; ///< of each entry; null: not loaded
    std::mutex m_bus;
    PluginServices m_services;
};

/// Loads the plugin, asks it for its devices and returns; the trial that `PluginHost` runs in another process.
/// @return what is wrong with the plugin, unless it ended the process
[[nodiscard]] core::Status probePlugin(const std::filesystem::path& file);

/// Runs such a trial for `PluginHost` and answers it: reads a random word from standard input before any code of the
/// plugin runs, and writes it to standard output when the plugin is fit. An exit code alone would prove nothing, as a
/// plugin may end the process with any.
/// @return as probePlugin
[[nodiscard]] core::Status answerProbe(const std::filesystem::path& file);

} // namespace palpate::device
