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

/// Version of everything in this header and in HapticDevice.h, layouts included: it rises with every change of a field
/// or a virtual function, for a plugin that was built before it would be misread. The compiler puts it into each
/// plugin (PALPATE_DEVICE_PLUGIN_IID) and its author into the metadata; one with another is refused before its code
/// is loaded.
inline constexpr int kDeviceApiVersion = 2;

/// What the program lends to a plugin; outlives everything the plugin makes.
struct PluginServices
{
    /// Held while a bus is listed and while a device is opened or closed: the libraries for that are shared between
    /// plugins and not thread-safe. Never held while reading or writing.
    std::mutex& bus;
    /// Where the user's settings of devices are, most important first.
    std::vector<std::filesystem::path> settingsFolders;
};

/// One device on the bus.
struct FoundDevice
{
    std::string name;    ///< for a person
    std::string address; ///< for `make`; stable while it stays plugged in
    std::string problem; ///< why it cannot be used now and what to do; empty: it can
};

/// What a plugin's root object implements. All calls come from one thread, never the servo thread.
class DevicePlugin
{
  public:
    virtual ~DevicePlugin() = default;

    /// Lists the devices on the bus that this plugin drives.
    virtual std::vector<FoundDevice> find(const PluginServices& services) = 0;
    /// Makes the driver; nothing is opened before its `start`.
    /// @param address  of a found device; empty: the first one there is when it starts
    virtual core::Result<std::unique_ptr<HapticDevice>> make(const PluginServices& services,
                                                             const std::string& address) = 0;
};

} // namespace palpate::device

#define PALPATE_DEVICE_PLUGIN_IID "palpate.DevicePlugin/2"
Q_DECLARE_INTERFACE(palpate::device::DevicePlugin, PALPATE_DEVICE_PLUGIN_IID)
