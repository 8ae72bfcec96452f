// SPDX-License-Identifier: BSD-3-Clause
#include "Driver.h"

#include <vendor/LibraryPlugin.h>

#include <QObject>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace palpate::openhaptics {

class Plugin final : public QObject, public vendor::LibraryPlugin<Settings, Scheduler>
{
    Q_OBJECT
    Q_PLUGIN_METADATA(IID PALPATE_DEVICE_PLUGIN_IID FILE "plugin.json")
    Q_INTERFACES(palpate::device::DevicePlugin)

  public:
    Plugin()
        : LibraryPlugin("3D Systems Touch")
    {
    }

  protected:
    core::Result<Settings> read(const std::vector<std::filesystem::path>& folders) override
    {
        return readSettings(folders);
    }

    core::Result<std::shared_ptr<Scheduler>> open(const device::PluginServices&, const Settings& settings) override
    {
        auto hd = loadHd(settings);
        if (!hd.isOk()) {
            return hd.status();
        }
        // Never destroyed: the library may call at any time.
        return std::shared_ptr<Scheduler>(new Scheduler(std::move(hd).value()), [](Scheduler*) {});
    }

    core::Result<std::unique_ptr<device::HapticDevice>> drive(const std::shared_ptr<Scheduler>& scheduler,
                                                              Settings settings, const std::string& address) override
    {
        std::string wanted = address.empty() ? settings.device : address;
        return std::make_unique<Driver>(*scheduler, std::move(settings), std::move(wanted));
    }
};

} // namespace palpate::openhaptics

#include "Plugin.moc"
