// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Models.h"
#include "RateHand.h"

#include <hid/HidDriver.h>
#include <palpate/core/TripleBuffer.h>
#include <palpate/device/DevicePresets.h>
#include <palpate/device/PlainCopy.h>

#include <atomic>

namespace palpate::spacemouse {

/// Lists 6-axis mice on the bus. Their other interfaces and other devices of the same vendors are excluded.
[[nodiscard]] std::vector<hid::HidEntry> listMice(std::mutex& bus);

/// 6-axis mouse as input device "spacemouse": the deflection of the puck controls the rate of the pose. No force
/// output. While unplugged, the pose does not move and the driver tries to reconnect.
class Driver final : public hid::HidDriver
{
  public:
    Driver(const device::PluginServices& services, const RateSettings& settings, std::string address);
    ~Driver() override;

    [[nodiscard]] device::DeviceInfo info() const override;
    core::Status start() override;
    [[nodiscard]] device::DeviceState read(std::int64_t now_ns) noexcept PALPATE_NONBLOCKING override;
    void write(const core::Vec3& f_D) noexcept PALPATE_NONBLOCKING override;
    [[nodiscard]] device::DeviceReport report() const override;
    core::Status calibrate() override;

  private:
    struct Heard
    {
        Held held;
        std::int64_t time_ns = 0;
    };

    void prepareThread() noexcept override;
    void serve(hid::HidDevice& mouse) noexcept override;
    void onDeviceLost() noexcept override;
    [[nodiscard]] std::vector<hid::HidEntry> list(std::mutex& bus) const override { return listMice(bus); }

    RateSettings m_settings;
    core::TripleBuffer<device::PlainCopy<Heard>> m_heard; // I/O thread -> servo thread
    RateHand m_hand;                                      // servo thread only

    std::atomic<bool> m_isRecentreWanted{false};
    std::atomic<bool> m_isLost{false};
};

} // namespace palpate::spacemouse
