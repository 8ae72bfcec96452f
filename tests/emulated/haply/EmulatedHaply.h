// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <haply/HaplyService.h>

#include <palpate/core/Types.h>
#include <palpate/device/PluginHost.h>
#include <palpate/servo/ServoLoop.h>

#include <QString>
#include <QTemporaryDir>

#include <functional>
#include <memory>
#include <string>

extern "C" void standin_makeTimeVirtual();
extern "C" void standin_makePollsVirtual();

namespace palpate::test {

/// Emulated Inverse Service for this process, and the user's settings for the plugin.
class EmulatedHaply
{
  public:
    EmulatedHaply();
    /// Writes haply.json with the port of the service and further fields: R"(, "device_id": "049D")".
    void configure(const std::string& more = {});
    void removeSettings();
    void with(const std::function<void(standin::HaplyBench&)>& act) { m_service.with(act); }
    void crash() { m_service.crash(); }
    /// Makes the service and its devices new: version 3.5 with one Inverse3.
    void renew();
    /// Moves the hand of a device to a place in the user frame [mm], in a smooth motion.
    void moveHand(const core::Vec3& p_mm, double duration_s, std::size_t device = 0);
    /// Force of the motors [N], user frame.
    [[nodiscard]] core::Vec3 motors(std::size_t device = 0);
    [[nodiscard]] std::string folder() const { return m_folder.path().toStdString(); }
    [[nodiscard]] std::uint16_t port() const { return m_service.port(); }

    /// Describes violations: a device driven beyond its limit, or for more than 10 ms without a new message, while the
    /// service works; a message that the service could not read. Empty: all is well.
    [[nodiscard]] QString violation(double limit_N = 10.0);

  private:
    QTemporaryDir m_folder;
    standin::HaplyService m_service;
};

/// Makes the shipped driver. @return null with a warning on failure
std::unique_ptr<device::HapticDevice> makeHaply(device::PluginHost& host, const std::string& address = {});

/// Writes a force in the user frame for some time, tick by tick.
void pushHaply(device::HapticDevice& device, const core::Vec3& f_U, double seconds);

} // namespace palpate::test
