// SPDX-License-Identifier: BSD-3-Clause
#include "Driver.h"

#include <QObject>

#include <system_error>

namespace palpate::woodenhaptics {

class Plugin final : public QObject, public device::DevicePlugin
{
    Q_OBJECT
    Q_PLUGIN_METADATA(IID PALPATE_DEVICE_PLUGIN_IID FILE "plugin.json")
    Q_INTERFACES(palpate::device::DevicePlugin)

  public:
    std::vector<device::FoundDevice> find(const device::PluginServices& services) override
    {
        std::vector<device::FoundDevice> found;
        for (const hid::HidEntry& entry : listArms(services.bus)) {
            found.push_back(
                {entry.productName.empty() ? "WoodenHaptics" : entry.productName, entry.path, entry.problem});
        }
        return found;
    }

    core::Result<std::unique_ptr<device::HapticDevice>> make(const device::PluginServices& services,
                                                             const std::string& address) override
    {
        Config config;
        for (const std::filesystem::path& folder : services.settingsFolders) {
            // The second name was written by older host programs.
            for (const char* name : {"woodenhaptics.json", "wooden_haptics.json"}) {
                std::error_code error;
                if (std::filesystem::exists(folder / name, error)) {
                    const auto read = readConfig(folder / name);
                    if (!read.isOk()) {
                        return read.status();
                    }
                    return std::unique_ptr<device::HapticDevice>(
                        std::make_unique<Driver>(services, read.value(), address));
                }
            }
        }
        return std::make_unique<Driver>(services, config, address);
    }
};

} // namespace palpate::woodenhaptics

#include "Plugin.moc"
