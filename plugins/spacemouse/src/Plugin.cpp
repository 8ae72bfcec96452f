// SPDX-License-Identifier: BSD-3-Clause
#include "Driver.h"
#include "Settings.h"

#include <QObject>

namespace palpate::spacemouse {

class Plugin final : public QObject, public device::DevicePlugin
{
    Q_OBJECT
    Q_PLUGIN_METADATA(IID PALPATE_DEVICE_PLUGIN_IID FILE "plugin.json")
    Q_INTERFACES(palpate::device::DevicePlugin)

  public:
    std::vector<device::FoundDevice> find(const device::PluginServices& services) override
    {
        std::vector<device::FoundDevice> found;
        for (const hid::HidEntry& entry : listMice(services.bus)) {
            found.push_back({findModel(entry.vendor, entry.product)->name, entry.path, entry.problem});
        }
        return found;
    }

    core::Result<std::unique_ptr<device::HapticDevice>> make(const device::PluginServices& services,
                                                             const std::string& address) override
    {
        const auto settings = readSettings(services.settingsFolders);
        if (!settings.isOk()) {
            return settings.status();
        }
        return std::make_unique<Driver>(services, settings.value(), address);
    }
};

} // namespace palpate::spacemouse

#include "Plugin.moc"
