// SPDX-License-Identifier: BSD-3-Clause
// A device plugin that misbehaves on start as configured in WAYWARD; built several times with different metadata.
#include <palpate/device/DevicePlugin.h>

#include <QObject>

#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#ifdef WAYWARD_IID // from an older or newer header
#undef PALPATE_DEVICE_PLUGIN_IID
#define PALPATE_DEVICE_PLUGIN_IID WAYWARD_IID
#endif

enum Way
{
    Crashes,
    Hangs,
    Throws,
    Exits,
    Works
};

class Wayward final : public QObject, public palpate::device::DevicePlugin
{
    Q_OBJECT
    Q_PLUGIN_METADATA(IID PALPATE_DEVICE_PLUGIN_IID FILE "plugin.json")
    Q_INTERFACES(palpate::device::DevicePlugin)

  public:
    Wayward()
    {
        switch (WAYWARD) {
        case Crashes:
            std::abort();
        case Hangs:
            std::this_thread::sleep_for(std::chrono::hours(1));
            break;
        case Exits:
            std::exit(0); // a regular exit
        default:
            break;
        }
    }
    std::vector<palpate::device::FoundDevice> find(const palpate::device::PluginServices&) override
    {
        if (WAYWARD == Throws) {
            throw std::runtime_error("no bus today");
        }
        return {{"a device", "here", ""}};
    }
    palpate::core::Result<std::unique_ptr<palpate::device::HapticDevice>> make(const palpate::device::PluginServices&,
                                                                               const std::string&) override
    {
        return palpate::core::Status(palpate::core::StatusCode::NotFound, PALPATE_TEXT("none"));
    }
};

#include "Wayward.moc"
