// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scheduler.h"

#include <palpate/device/HapticDevice.h>

#include <memory>
#include <string>

namespace palpate::openhaptics {

/// Device of 3D Systems as device "openhaptics". The callback of the library's scheduler exchanges the latest state and
/// force with the servo thread.
class Driver final : public device::HapticDevice
{
  public:
    /// @param wanted  name of a configuration or serial number; empty: the default device
    Driver(Scheduler& scheduler, Settings settings, std::string wanted);
    ~Driver() override;

    /// Limits of the device if connected at construction; otherwise cautious limits until `start`.
    [[nodiscard]] device::DeviceInfo info() const override;
    core::Status start() override;
    void stop() noexcept override;
    [[nodiscard]] device::DeviceState read(std::int64_t now_ns) noexcept PALPATE_NONBLOCKING override;
    void write(const core::Vec3& f_D) noexcept PALPATE_NONBLOCKING override;
    [[nodiscard]] device::DeviceReport report() const override;
    /// Takes the present pose as the reset pose, where the device is calibrated this way.
    core::Status calibrate() override;

  private:
    core::Status open();

    Scheduler& m_scheduler;
    Settings m_settings;
    std::string m_wanted;
    Limits m_limits;
    std::string m_name;
    std::shared_ptr<Channel> m_channel; ///< open from construction or `start` to `stop`
    bool m_isStarted = false;
};

} // namespace palpate::openhaptics
