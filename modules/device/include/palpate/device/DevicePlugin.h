// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/device/HapticDevice.h"

#include <QtPlugin>

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace palpate::device {

/// Version of the interface in this header and in HapticDevice.h, including layouts. Increment for every change of a
/// field or virtual function, because older plugins would misread the data. The compiler embeds the version in each
/// plugin (PALPATE_DEVICE_PLUGIN_IID) and the author states the version in the metadata; a plugin with a different
/// version is rejected before its code is loaded.
inline constexpr int kDeviceApiVersion = 3;

/// Services of the host program for a plugin; they outlive all objects of the plugin.
struct PluginServices
{
    /// Locked while listing a bus and while opening or closing a device, because the underlying libraries are shared
    /// between plugins and not thread-safe. Never locked while reading or writing.
    std::mutex& bus;
    /// Folders with the user's device settings, highest priority first.
    std::vector<std::filesystem::path> settingsFolders;
};

/// One device on the bus.
struct FoundDevice
{
    std::string name;    ///< display name
    std::string address; ///< argument for `make`; stable while the device is plugged in
    std::string problem; ///< reason why the device is currently unusable, and the remedy; empty if usable
};

/// Interface of a plugin's root object. All calls come from one thread, never from the servo thread.
class DevicePlugin
{
  public:
    virtual ~DevicePlugin() = default;

    /// Lists the connected devices supported by this plugin.
    virtual std::vector<FoundDevice> find(const PluginServices& services) = 0;
    /// Creates the driver; the device is opened in `HapticDevice::start`.
    /// @param address  address of a found device; empty: the first device present at start
    virtual core::Result<std::unique_ptr<HapticDevice>> make(const PluginServices& services,
                                                             const std::string& address) = 0;
};

} // namespace palpate::device

#define PALPATE_DEVICE_PLUGIN_IID "palpate.DevicePlugin/3"
Q_DECLARE_INTERFACE(palpate::device::DevicePlugin, PALPATE_DEVICE_PLUGIN_IID)
