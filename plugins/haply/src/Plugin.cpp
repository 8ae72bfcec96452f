// SPDX-License-Identifier: BSD-3-Clause
#include "Driver.h"

#include <QObject>

namespace palpate::haply {

class Plugin final : public QObject, public device::DevicePlugin
{
    Q_OBJECT
    Q_PLUGIN_METADATA(IID PALPATE_DEVICE_PLUGIN_IID FILE "plugin.json")
    Q_INTERFACES(palpate::device::DevicePlugin)

  public:
    /// Empty where the maker's service does not run, since most users have no device of this maker; `start` of a device
    /// states the reason.
    std::vector<device::FoundDevice> find(const device::PluginServices& services) override
    {
        const auto settings = readSettings(services.settingsFolders);
        if (!settings.isOk()) {
            return {{"Haply", "", settings.status().message()}};
        }
        return listDevices(settings.value());
    }

    core::Result<std::unique_ptr<device::HapticDevice>> make(const device::PluginServices& services,
                                                             const std::string& address) override
    {
        auto settings = readSettings(services.settingsFolders);
        if (!settings.isOk()) {
            return settings.status();
        }
        const std::string id = address.empty() ? settings.value().deviceId : address;
        return std::make_unique<Driver>(std::move(settings).value(), id);
    }
};

} // namespace palpate::haply

#include "Plugin.moc"
