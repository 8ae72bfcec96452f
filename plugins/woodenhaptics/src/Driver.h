// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Conversation.h"

#include <hid/HidDriver.h>
#include <palpate/core/TripleBuffer.h>
#include <palpate/device/PlainCopy.h>

#include <atomic>

namespace palpate::woodenhaptics {

/// Arms on the bus; other mbed boards with the same ids are left out by the name that they state.
[[nodiscard]] std::vector<hid::HidEntry> listArms(std::mutex& bus);

/// The arm as a device, "woodenhaptics". A thread of its own talks to it and only exchanges newest state and newest
/// force with the servo thread. A lost arm is looked for until it is back; after that it has to be calibrated.
class Driver final : public hid::HidDriver
{
  public:
    Driver(const device::PluginServices& services, const Config& config, std::string address);
    ~Driver() override;

    [[nodiscard]] device::DeviceInfo info() const override;
    /// Opens the arm and waits until it talks.
    core::Status start() override;
    [[nodiscard]] device::DeviceState read(std::int64_t now_ns) noexcept PALPATE_NONBLOCKING override;
    void write(const core::Vec3& f_D) noexcept PALPATE_NONBLOCKING override;
    [[nodiscard]] device::DeviceReport report() const override;
    core::Status calibrate() override;

  private:
    /// What the servo thread wants of the motors.
    struct Push
    {
        core::Vec3 f_D = core::Vec3::Zero(); ///< [N]
        std::int64_t answers_ns = 0;         ///< time of the state that it was computed from
        std::int64_t time_ns = 0;
    };

    void makeThreadReady() noexcept override;
    void serve(hid::HidDevice& arm) noexcept override;
    void tellLost() noexcept override;
    [[nodiscard]] std::vector<hid::HidEntry> list(std::mutex& bus) const override { return listArms(bus); }
    void publish(const Conversation& talk) noexcept;

    Config m_config;
    bool m_isTrusted = true; ///< I/O thread's: it was switched on in its calibration pose, as its makers ask
    std::atomic<bool> m_isCalibrationWanted{false};

    core::TripleBuffer<device::PlainCopy<device::DeviceState>> m_state; // I/O thread -> servo thread
    core::TripleBuffer<device::PlainCopy<Push>> m_push;                 // servo thread -> I/O thread
    std::int64_t m_answers_ns = 0;                                      // servo thread's: time of the state last read

    // For report(), from the I/O thread.
    std::atomic<device::DeviceCondition> m_condition{device::DeviceCondition::Working};
    std::atomic<int> m_protocol{0};
    std::atomic<std::size_t> m_strangeLength{0};
    core::TimingHistogram m_latency;
};

} // namespace palpate::woodenhaptics
