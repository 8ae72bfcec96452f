// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Conversation.h"

#include <hid/HidBus.h>
#include <palpate/core/TripleBuffer.h>
#include <palpate/device/DevicePlugin.h>
#include <palpate/device/PlainCopy.h>

#include <atomic>
#include <optional>
#include <thread>

namespace palpate::woodenhaptics {

/// Arms on the bus; other mbed boards with the same ids are left out by the name that they state.
[[nodiscard]] std::vector<hid::HidEntry> listArms(std::mutex& bus);

/// The arm as a device, "woodenhaptics". A thread of its own talks to it and only exchanges newest state and newest
/// force with the servo thread. A lost arm is looked for until it is back; after that it has to be calibrated.
class Driver final : public device::HapticDevice
{
  public:
    Driver(const device::PluginServices& services, const Config& config, std::string address);
    ~Driver() override;

    [[nodiscard]] device::DeviceInfo info() const override;
    /// Opens the arm and waits until it talks.
    core::Status start() override;
    void stop() noexcept override;
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

    void run(hid::HidDevice first) noexcept;
    void serve(hid::HidDevice& arm, bool isTrusted) noexcept;
    [[nodiscard]] std::optional<hid::HidDevice> find() noexcept;
    void publish(const Conversation& talk) noexcept;

    std::mutex& m_bus;
    Config m_config;
    std::string m_address;
    std::thread m_thread;
    std::atomic<bool> m_isStopRequested{false};
    std::atomic<bool> m_isCalibrationWanted{false};

    core::TripleBuffer<device::PlainCopy<device::DeviceState>> m_state; // I/O thread -> servo thread
    core::TripleBuffer<device::PlainCopy<Push>> m_push;                 // servo thread -> I/O thread
    std::int64_t m_answers_ns = 0;                                      // servo thread's: time of the state last read

    // For report(), from the I/O thread.
    std::atomic<device::DeviceCondition> m_condition{device::DeviceCondition::Working};
    std::atomic<int> m_protocol{0};
    std::atomic<std::size_t> m_strangeLength{0};
    std::atomic<std::uint64_t> m_states{0};
    std::atomic<std::uint64_t> m_refused{0};
    std::atomic<std::uint64_t> m_losses{0};
    core::TimingHistogram m_latency;
};

} // namespace palpate::woodenhaptics
