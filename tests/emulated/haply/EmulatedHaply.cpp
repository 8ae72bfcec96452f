// SPDX-License-Identifier: BSD-3-Clause
#include "EmulatedHaply.h"

#include "EmulatedArm.h"

#include <QFile>

#include <algorithm>
#include <cstdlib>

namespace palpate::test {

EmulatedHaply::EmulatedHaply()
{
    setenv("XDG_CONFIG_HOME", m_folder.path().toUtf8().constData(), 1); // independent of the user's settings
    setenv("HOME", m_folder.path().toUtf8().constData(), 1);
    configure();
}

void EmulatedHaply::configure(const std::string& more)
{
    QFile settings(m_folder.filePath(QStringLiteral("haply.json")));
    if (!settings.open(QIODevice::WriteOnly)) {
        qFatal("no settings");
    }
    const std::string port = std::to_string(m_service.port());
    settings.write(("{\"port\": " + port + ", \"http_port\": " + port + more + '}').c_str());
}

void EmulatedHaply::removeSettings()
{
    QFile::remove(m_folder.filePath(QStringLiteral("haply.json")));
}

void EmulatedHaply::renew()
{
    configure();
    with([](standin::HaplyBench& b) {
        const std::int64_t sim_ns = b.sim_ns;
        const int open = b.openSessions;
        b = {};
        b.sim_ns = sim_ns;
        b.openSessions = open;
    });
}

void EmulatedHaply::moveHand(const core::Vec3& p_mm, double duration_s, std::size_t device)
{
    with([&](standin::HaplyBench& b) {
        standin::HaplyDevice& d = b.devices[device];
        d.from = d.to;
        d.to = {p_mm.x() * 1e-3, p_mm.y() * 1e-3, p_mm.z() * 1e-3};
        d.begin_ns = b.sim_ns;
        d.duration_s = duration_s;
    });
}

core::Vec3 EmulatedHaply::motors(std::size_t device)
{
    core::Vec3 f = core::Vec3::Zero();
    with([&](standin::HaplyBench& b) { f = core::Vec3(b.devices[device].f.data()); });
    return f;
}

QString EmulatedHaply::violation(double limit_N)
{
    std::string found;
    with([&](standin::HaplyBench& b) {
        for (const standin::HaplyDevice& d : b.devices) {
            if (!(d.largestForce_N <= limit_N * (1.0 + 1e-9))) {
                found += "driven with " + std::to_string(d.largestForce_N) + " N; ";
            }
            if (d.longestSilence_ns > 10'000'000) {
                found += "driven for " + std::to_string(d.longestSilence_ns) + " ns without a new message; ";
            }
        }
        found += b.lastError;
    });
    return QString::fromStdString(found);
}

std::unique_ptr<device::HapticDevice> makeHaply(device::PluginHost& host, const std::string& address)
{
    auto made = host.make("haply", address);
    if (!made.isOk()) {
        qWarning("%s", made.status().message().c_str());
        return nullptr;
    }
    return std::move(made).value();
}

void pushHaply(device::HapticDevice& device, const core::Vec3& f_U, double seconds)
{
    const core::Vec3 f_D = device.info().q_UD.conjugate() * f_U;
    for (int i = 0; i < static_cast<int>(seconds * 1000.0); ++i) {
        pass(0.001);
        (void)device.read(core::monotonicNow_ns());
        device.write(f_D);
    }
}

} // namespace palpate::test
