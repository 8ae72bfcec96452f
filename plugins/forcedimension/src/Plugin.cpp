// SPDX-License-Identifier: BSD-3-Clause
#include "Driver.h"

#include <QObject>

#include <charconv>

namespace palpate::forcedimension {

class Plugin final : public QObject, public device::DevicePlugin
{
    Q_OBJECT
    Q_PLUGIN_METADATA(IID PALPATE_DEVICE_PLUGIN_IID FILE "plugin.json")
    Q_INTERFACES(palpate::device::DevicePlugin)

  public:
    /// Empty where the maker's library is not installed, since most users have no device of this maker; `make` states
    /// the reason.
    std::vector<device::FoundDevice> find(const device::PluginServices& services) override
    {
        const auto settings = readSettings(services.settingsFolders);
        if (!settings.isOk()) {
            return {{"Force Dimension", "", settings.status().message()}};
        }
        const Status loaded = load(services, settings.value());
        if (loaded.isOk()) {
            return m_bus->list();
        }
        if (loaded.code() == core::StatusCode::NotFound && settings.value().library.empty()) {
            return {};
        }
        return {{"Force Dimension", "", loaded.message()}};
    }

    core::Result<std::unique_ptr<device::HapticDevice>> make(const device::PluginServices& services,
                                                             const std::string& address) override
    {
        auto settings = readSettings(services.settingsFolders);
        if (!settings.isOk()) {
            return settings.status();
        }
        if (const Status loaded = load(services, settings.value()); !loaded.isOk()) {
            return loaded;
        }
        int serial = settings.value().serial;
        const char* const end = address.data() + address.size();
        if (!address.empty() && std::from_chars(address.data(), end, serial).ptr != end) {
            return Status(core::StatusCode::BadCommandLine,
                          PALPATE_TEXT("forcedimension: found the address \"%1\", expected a serial number"), address);
        }
        return std::make_unique<Driver>(m_bus, std::move(settings).value(), serial);
    }

  private:
    using Status = core::Status;

    /// Loads the library once; a failed attempt is repeated, because the user may install the library meanwhile.
    Status load(const device::PluginServices& services, const Settings& settings)
    {
        if (m_bus != nullptr) {
            return {};
        }
        auto dhd = loadDhd(settings);
        if (dhd.isOk()) {
            m_bus = std::make_shared<Bus>(std::move(dhd).value(), services.bus);
        }
        return dhd.status();
    }

    std::shared_ptr<Bus> m_bus;
};

} // namespace palpate::forcedimension

#include "Plugin.moc"
