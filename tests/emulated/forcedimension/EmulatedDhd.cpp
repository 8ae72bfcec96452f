// SPDX-License-Identifier: BSD-3-Clause
#include "EmulatedDhd.h"

#include <QFile>

#include <algorithm>
#include <cstdlib>

namespace palpate::test {

EmulatedDhd::EmulatedDhd(const std::string& file)
    : m_file(file.empty() ? m_folder.filePath(QStringLiteral("dhd")).toStdString() : file)
{
    setenv("PALPATE_STANDIN_DHD", m_file.c_str(), 1);
    setenv("XDG_CONFIG_HOME", m_folder.path().toUtf8().constData(), 1); // independent of the user's settings
    setenv("HOME", m_folder.path().toUtf8().constData(), 1);
    unsetenv("FDSDK");
    m_bench = standin::openDhdBench(m_file.c_str());
    configure();
}

void EmulatedDhd::configure(const std::string& more, const std::string& library)
{
    QFile settings(m_folder.filePath(QStringLiteral("forcedimension.json")));
    if (!settings.open(QIODevice::WriteOnly)) {
        qFatal("no settings");
    }
    settings.write(("{\"library\": \"" + library + '"' + more + '}').c_str());
}

void EmulatedDhd::removeSettings()
{
    QFile::remove(m_folder.filePath(QStringLiteral("forcedimension.json")));
}

void EmulatedDhd::with(const std::function<void(standin::DhdBench&)>& act)
{
    standin::lockDhd(*m_bench);
    standin::advanceDhd(*m_bench, core::monotonicNow_ns());
    act(*m_bench);
    standin::unlockDhd(*m_bench);
}

void EmulatedDhd::renew()
{
    configure();
    with([](standin::DhdBench& b) {
        for (standin::DhdDevice& device : b.devices) {
            const std::uint32_t plugins = device.plugins + 1;
            const int serial = device.serial;
            device = {};
            device.plugins = plugins;
            device.serial = serial;
        }
        b.count = 1;
        b.order = {0, 1};
        b.unnamedCalls = 0;
        b.lateCalls = 0;
    });
}

void EmulatedDhd::moveHand(const core::Vec3& p_mm, double duration_s, std::size_t device)
{
    with([&](standin::DhdBench& b) {
        standin::DhdDevice& d = b.devices[device];
        d.from = d.to;
        d.to = {p_mm.x() * 1e-3, p_mm.y() * 1e-3, p_mm.z() * 1e-3};
        d.begin_ns = b.sim_ns;
        d.duration_s = duration_s;
    });
}

core::Vec3 EmulatedDhd::motors(std::size_t device)
{
    core::Vec3 f = core::Vec3::Zero();
    with([&](standin::DhdBench& b) { f = core::Vec3(b.devices[device].f.data()); });
    return f;
}

QString EmulatedDhd::violation(double limit_N)
{
    std::string found;
    with([&](standin::DhdBench& b) {
        for (const standin::DhdDevice& d : b.devices) {
            if (!(d.largestForce_N <= limit_N * (1.0 + 1e-9))) {
                found += "driven with " + std::to_string(d.largestForce_N) + " N; ";
            }
            if (d.longestSilence_ns > 10'000'000) {
                found += "driven for " + std::to_string(d.longestSilence_ns) + " ns without a new force; ";
            }
        }
        if (b.unnamedCalls > 0 || b.lateCalls > 0) {
            found += std::to_string(b.unnamedCalls) + " calls for the default device, " + std::to_string(b.lateCalls) +
                     " after closing; ";
        }
    });
    return QString::fromStdString(found);
}

core::Vec3 toDevice(const device::HapticDevice& device, const core::Vec3& v_U)
{
    return device.info().q_UD.conjugate() * v_U;
}

core::Vec3 toUser(const device::HapticDevice& device, const core::Vec3& v_D)
{
    return device.info().q_UD * v_D;
}

std::unique_ptr<device::HapticDevice> makeDhd(device::PluginHost& host)
{
    auto made = host.make("forcedimension");
    if (!made.isOk()) {
        qWarning("%s", made.status().message().c_str());
        return nullptr;
    }
    return std::move(made).value();
}

} // namespace palpate::test
