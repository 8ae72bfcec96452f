// SPDX-License-Identifier: BSD-3-Clause
#include "Driver.h"

#include <palpate/core/Clock.h>

#include <QObject>

#include <poll.h>
#include <utility>

namespace palpate::openigtlink {

class Plugin final : public QObject, public device::DevicePlugin
{
    Q_OBJECT
    Q_PLUGIN_METADATA(IID PALPATE_DEVICE_PLUGIN_IID FILE "plugin.json")
    Q_INTERFACES(palpate::device::DevicePlugin)

  public:
    /// Connects to the server and measures the rate of the poses. Empty without a server unless the user has settings,
    /// since most users have no server.
    std::vector<device::FoundDevice> find(const device::PluginServices& services) override
    {
        const auto settings = readSettings(services.settingsFolders);
        if (!settings.isOk()) {
            return {{"OpenIGTLink", "", settings.status().message()}};
        }
        constexpr int kTimeout_ms = 200;
        auto socket = igtl::connectTo(settings.value().host, settings.value().port, kTimeout_ms);
        if (socket.isOk()) {
            return {listen(settings.value(), std::move(socket).value())};
        }
        if (settings.value().isFromFile) {
            return {{"OpenIGTLink", addressOf(settings.value()), socket.status().message()}};
        }
        return {};
    }

    core::Result<std::unique_ptr<device::HapticDevice>> make(const device::PluginServices& services,
                                                             const std::string&) override
    {
        auto settings = readSettings(services.settingsFolders);
        if (!settings.isOk()) {
            return settings.status();
        }
        return std::make_unique<Driver>(std::move(settings).value());
    }

  private:
    [[nodiscard]] static std::string addressOf(const Settings& settings)
    {
        return settings.host + ":" + std::to_string(settings.port);
    }

    /// Listens for half a second.
    [[nodiscard]] static device::FoundDevice listen(const Settings& settings, igtl::Socket socket)
    {
        constexpr std::int64_t kListen_ns = 500'000'000;
        constexpr int kWait_ms = 10;
        igtl::Connection connection(std::move(socket), false);
        if (settings.requestEvery_ms > 0) {
            (void)connection.send(igtl::encodeMessage(
                "STT_TDATA", "", igtl::encodeTrackingRequest({settings.requestEvery_ms, {}}), igtl::timestampNow()));
        }
        PoseStream stream(settings);
        bool isOpen = true;
        for (const std::int64_t end_ns = core::monotonicNow_ns() + kListen_ns;
             isOpen && core::monotonicNow_ns() < end_ns;) {
            pollfd waiting{connection.descriptor(), POLLIN, 0};
            (void)::poll(&waiting, 1, kWait_ms);
            isOpen = connection.receive(
                [&stream](const igtl::Message& message) { (void)stream.take(message, core::monotonicNow_ns()); });
        }
        device::FoundDevice found{"OpenIGTLink", addressOf(settings), ""};
        if (stream.interval_ns() > 0) {
            found.name = stream.tool() + ", " +
                         feelText(1e9 / static_cast<double>(stream.interval_ns()), !settings.force.empty());
        } else {
            const std::string reason = !stream.problem().empty() ? stream.problem() : connection.problem();
            found.problem = reason.empty() ? "the server answers, but sends no position" : reason;
        }
        return found;
    }
};

} // namespace palpate::openigtlink

#include "Plugin.moc"
