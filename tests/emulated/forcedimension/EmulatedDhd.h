// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <DhdBench.h>

#include <palpate/core/Clock.h>
#include <palpate/device/PluginHost.h>

#include <QString>
#include <QTemporaryDir>

#include <functional>
#include <memory>
#include <string>

extern "C" void standin_makeTimeVirtual();

namespace palpate::test {

/// Emulated devices of Force Dimension for this process, and the user's settings for the plugin. The first object in a
/// process determines the bench.
class EmulatedDhd
{
  public:
    /// @param file  bench to share with another process; empty: a new one
    explicit EmulatedDhd(const std::string& file = {});
    /// Writes forcedimension.json with the stand-in library and further fields: R"(, "serial": 1002)".
    void configure(const std::string& more = {}, const std::string& library = PALPATE_DHD_WHOLE "/libdhd.so.3");
    void removeSettings();
    /// Calls a function with the bench locked and advanced to the current time.
    void with(const std::function<void(standin::DhdBench&)>& act);
    /// Makes all devices new, with two omega.3 of which one is on the bus.
    void renew();
    /// Moves the hand of a device to a place in the user frame [mm], in a smooth motion.
    void moveHand(const core::Vec3& p_mm, double duration_s, std::size_t device = 0);
    /// Force of the motors [N], user frame.
    [[nodiscard]] core::Vec3 motors(std::size_t device = 0);
    [[nodiscard]] const std::string& file() const noexcept { return m_file; }
    [[nodiscard]] std::string folder() const { return m_folder.path().toStdString(); }

    /// Describes violations: a device driven beyond its limit or for more than 10 ms without a new force, a call that
    /// names no open device. Empty: all is well.
    [[nodiscard]] QString violation(double limit_N = 12.0);

  private:
    QTemporaryDir m_folder;
    std::string m_file;
    standin::DhdBench* m_bench = nullptr;
};

/// Direct mapping of the user frame to the device's frame.
[[nodiscard]] core::Vec3 toDevice(const device::HapticDevice& device, const core::Vec3& v_U);
[[nodiscard]] core::Vec3 toUser(const device::HapticDevice& device, const core::Vec3& v_D);

/// Makes the shipped driver. @return null with a warning on failure
std::unique_ptr<device::HapticDevice> makeDhd(device::PluginHost& host);

} // namespace palpate::test
