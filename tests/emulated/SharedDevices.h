// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <SharedBench.h>

#include <palpate/core/Clock.h>
#include <palpate/core/Types.h>
#include <palpate/device/PluginHost.h>

#include <QFile>
#include <QString>
#include <QTemporaryDir>

#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace palpate::test {

/// Emulated devices behind a stand-in of their maker's library, for this process, and the user's settings for the
/// plugin. The first object in a process determines the bench. Bench: as SharedBench.h describes, with `devices`.
template<class Bench>
class SharedDevices
{
  public:
    struct Kind
    {
        const char* plugin;   ///< "forcedimension"
        const char* variable; ///< that names the bench for the library
        const char* library;  ///< path of the stand-in
        std::uint64_t magic;  ///< of the bench
        void (*advance)(Bench&, std::int64_t now_ns);
        core::Vec3 out_U; ///< z axis of the device's frame, the normal of the block of `blockScene`, in the user frame
    };

    /// @param file  bench to share with another process; empty: a new one
    SharedDevices(const Kind& kind, const std::string& file)
        : m_kind(kind)
        , m_file(file.empty() ? m_folder.filePath(QStringLiteral("bench")).toStdString() : file)
    {
        setenv(kind.variable, m_file.c_str(), 1);
        setenv("XDG_CONFIG_HOME", m_folder.path().toUtf8().constData(), 1); // independent of the user's settings
        setenv("HOME", m_folder.path().toUtf8().constData(), 1);
        m_bench = standin::openShared<Bench>(m_file.c_str(), kind.magic);
        configure();
    }

    /// Writes the settings with the stand-in library and further fields: R"(, "serial": 1002)".
    void configure(const std::string& more = {}) { configure(more, m_kind.library); }
    void configure(const std::string& more, const std::string& library)
    {
        QFile settings(settingsPath());
        if (!settings.open(QIODevice::WriteOnly)) {
            qFatal("no settings");
        }
        settings.write(("{\"library\": \"" + library + '"' + more + '}').c_str());
    }
    void removeSettings() { QFile::remove(settingsPath()); }
    /// Calls a function with the bench locked and advanced to the current time.
    void with(const std::function<void(Bench&)>& act)
    {
        standin::lockShared(*m_bench);
        m_kind.advance(*m_bench, core::monotonicNow_ns());
        act(*m_bench);
        standin::unlockShared(*m_bench);
    }
    /// Moves the hand of a device to a place in the user frame [mm], in a smooth motion.
    void moveHand(const core::Vec3& p_mm, double duration_s, std::size_t device = 0)
    {
        with([&](Bench& b) {
            standin::moveTip(b.devices[device], {p_mm.x() * 1e-3, p_mm.y() * 1e-3, p_mm.z() * 1e-3}, duration_s,
                             b.sim_ns);
        });
    }
    /// Moves the hand of the first device above the block of `blockScene` (> 0), or into it [mm].
    void lift(double height_mm, double duration_s) { moveHand(height_mm * m_kind.out_U, duration_s); }
    /// Force of the motors of the first device out of the block [N].
    [[nodiscard]] double pressure_N() { return motors().dot(m_kind.out_U); }
    /// Force of the motors [N], user frame.
    [[nodiscard]] core::Vec3 motors(std::size_t device = 0)
    {
        core::Vec3 f = core::Vec3::Zero();
        with([&](Bench& b) { f = core::Vec3(b.devices[device].f.data()); });
        return f;
    }
    /// Makes the shipped driver. @return null with a warning on failure
    [[nodiscard]] std::unique_ptr<device::HapticDevice> make(device::PluginHost& host,
                                                             const std::string& address = {}) const
    {
        auto made = host.make(m_kind.plugin, address);
        if (!made.isOk()) {
            qWarning("%s", made.status().message().c_str());
            return nullptr;
        }
        return std::move(made).value();
    }
    /// The first force of the first device that carries the position of a sample as its force (1 N for 1 mm): its delay
    /// since the sample, for each sample.
    [[nodiscard]] std::vector<std::int64_t> delays()
    {
        std::vector<std::int64_t> found;
        with([&](Bench& b) {
            const auto& d = b.devices[0];
            const std::uint64_t size = d.forces.size();
            core::Vec3 before = core::Vec3::Zero();
            for (std::uint64_t i = d.forceCount > size ? d.forceCount - size : 0; i < d.forceCount; ++i) {
                const auto& force = d.forces[i % size];
                const core::Vec3 f(force.f.data());
                if (f.isApprox(before) || f.norm() < 0.5) {
                    continue;
                }
                before = f;
                for (std::uint64_t j = d.sampleCount > size ? d.sampleCount - size : 0; j < d.sampleCount; ++j) {
                    const auto& sample = d.samples[j % size];
                    if ((core::Vec3(sample.p.data()) * 1000.0 - f).norm() < 1e-9) {
                        found.push_back(force.time_ns - sample.time_ns);
                        break;
                    }
                }
            }
        });
        return found;
    }
    [[nodiscard]] const core::Vec3& out_U() const noexcept { return m_kind.out_U; }
    [[nodiscard]] const std::string& file() const noexcept { return m_file; }
    [[nodiscard]] std::string folder() const { return m_folder.path().toStdString(); }

  private:
    [[nodiscard]] QString settingsPath() const
    {
        return m_folder.filePath(QLatin1String(m_kind.plugin) + QStringLiteral(".json"));
    }

    QTemporaryDir m_folder;
    Kind m_kind;
    std::string m_file;
    Bench* m_bench = nullptr;
};

/// Direct mapping of the user frame to the device's frame.
[[nodiscard]] inline core::Vec3 toDevice(const device::HapticDevice& device, const core::Vec3& v_U)
{
    return device.info().q_UD.conjugate() * v_U;
}
[[nodiscard]] inline core::Vec3 toUser(const device::HapticDevice& device, const core::Vec3& v_D)
{
    return device.info().q_UD * v_D;
}

} // namespace palpate::test
