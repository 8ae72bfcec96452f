// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/device/DevicePlugin.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace palpate::vendor {

/// Root object of a plugin that needs the library of a maker.
/// @tparam Settings  derived from VendorSettings
/// @tparam Bus  finds and opens devices, with a function `list`
template<class Settings, class Bus>
class LibraryPlugin : public device::DevicePlugin
{
  public:
    /// @param name  of the devices, for the list: "Force Dimension"
    explicit LibraryPlugin(const char* name)
        : m_name(name)
    {
    }

    /// Empty where the maker's library is not installed, since most users have no device of this maker; `make` states
    /// the reason.
    std::vector<device::FoundDevice> find(const device::PluginServices& services) override
    {
        const auto settings = read(services.settingsFolders);
        if (!settings.isOk()) {
            return {{m_name, "", settings.status().message()}};
        }
        const core::Status loaded = load(services, settings.value());
        if (loaded.isOk()) {
            return m_bus->list();
        }
        if (loaded.code() == core::StatusCode::NotFound && settings.value().library.empty()) {
            return {};
        }
        return {{m_name, "", loaded.message()}};
    }

    core::Result<std::unique_ptr<device::HapticDevice>> make(const device::PluginServices& services,
                                                             const std::string& address) override
    {
        auto settings = read(services.settingsFolders);
        if (!settings.isOk()) {
            return settings.status();
        }
        if (core::Status loaded = load(services, settings.value()); !loaded.isOk()) {
            return loaded;
        }
        return drive(m_bus, std::move(settings).value(), address);
    }

  protected:
    [[nodiscard]] virtual core::Result<Settings> read(const std::vector<std::filesystem::path>& folders) = 0;
    /// Opens the library.
    [[nodiscard]] virtual core::Result<std::shared_ptr<Bus>> open(const device::PluginServices& services,
                                                                  const Settings& settings) = 0;
    /// Makes the driver.
    [[nodiscard]] virtual core::Result<std::unique_ptr<device::HapticDevice>>
    drive(const std::shared_ptr<Bus>& bus, Settings settings, const std::string& address) = 0;

  private:
    /// Loads the library once; a failed attempt is repeated, because the user may install the library meanwhile.
    core::Status load(const device::PluginServices& services, const Settings& settings)
    {
        if (m_bus != nullptr) {
            return {};
        }
        auto opened = open(services, settings);
        if (opened.isOk()) {
            m_bus = std::move(opened).value();
        }
        return opened.status();
    }

    const char* m_name;
    std::shared_ptr<Bus> m_bus;
};

} // namespace palpate::vendor
