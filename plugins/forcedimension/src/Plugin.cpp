// SPDX-License-Identifier: BSD-3-Clause
#include "Driver.h"

#include <vendor/LibraryPlugin.h>

#include <QObject>

#include <charconv>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace palpate::forcedimension {

class Plugin final : public QObject, public vendor::LibraryPlugin<Settings, Bus>
{
    Q_OBJECT
    Q_PLUGIN_METADATA(IID PALPATE_DEVICE_PLUGIN_IID FILE "plugin.json")
    Q_INTERFACES(palpate::device::DevicePlugin)

  public:
    Plugin()
        : LibraryPlugin("Force Dimension")
    {
    }

  protected:
    core::Result<Settings> read(const std::vector<std::filesystem::path>& folders) override
    {
        return readSettings(folders);
    }

    core::Result<std::shared_ptr<Bus>> open(const device::PluginServices& services, const Settings& settings) override
    {
        auto dhd = loadDhd(settings);
        if (!dhd.isOk()) {
            return dhd.status();
        }
        return std::make_shared<Bus>(std::move(dhd).value(), services.bus);
    }

    core::Result<std::unique_ptr<device::HapticDevice>> drive(const std::shared_ptr<Bus>& bus, Settings settings,
                                                              const std::string& address) override
    {
        int serial = settings.serial;
        const char* const end = address.data() + address.size();
        if (!address.empty() && std::from_chars(address.data(), end, serial).ptr != end) {
            return core::Status(core::StatusCode::BadCommandLine,
                                PALPATE_TEXT("forcedimension: found the address \"%1\", expected a serial number"),
                                address);
        }
        return std::make_unique<Driver>(bus, std::move(settings), serial);
    }
};

} // namespace palpate::forcedimension

#include "Plugin.moc"
