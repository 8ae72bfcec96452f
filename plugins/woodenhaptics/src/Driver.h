// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Conversation.h"

#include <hid/HidDriver.h>
#include <palpate/core/TripleBuffer.h>
#include <palpate/device/PlainCopy.h>

#include <atomic>

namespace palpate::woodenhaptics {

/// Lists arms on the bus. Other mbed boards with the same ids are excluded by product name.
[[nodiscard]] std::vector<hid::HidEntry> listArms(std::mutex& bus);

/// WoodenHaptics arm as device "woodenhaptics". A separate I/O thread serves the arm and exchanges the latest state
/// and force with the servo thread. After a loss the driver reconnects; the arm then has to be calibrated.
class Driver final : public hid::HidDriver
{
  public:
    Driver(const device::PluginServices& services, const Config& config, std::string address);
    ~Driver() override;

    [[nodiscard]] device::DeviceInfo info() const override;
    /// Opens the arm and waits for its first reports.
    core::Status start() override;
    [[nodiscard]] device::DeviceState read(std::int64_t now_ns) noexcept PALPATE_NONBLOCKING override;
    void write(const core::Vec3& f_D) noexcept PALPATE_NONBLOCKING override;
    [[nodiscard]] device::DeviceReport report() const override;
    core::Status calibrate() override;

  private:
    /// Force command from the servo thread.
    struct ForceCommand
    {
        core::Vec3 f_D = core::Vec3::Zero(); ///< [N]
        std::int64_t answers_ns = 0;         ///< time stamp of the state from which the force was computed
        std::int64_t time_ns = 0;
    };

    void prepareThread() noexcept override;
    void serve(hid::HidDevice& arm) noexcept override;
    void onDeviceLost() noexcept override;
    [[nodiscard]] std::vector<hid::HidEntry> list(std::mutex& bus) const override { return listArms(bus); }
    void publish(const Conversation& talk) noexcept;

    Config m_config;
    /// I/O thread only: the arm was switched on in the calibration pose, as its makers require.
    bool m_isTrusted = true;
    std::atomic<bool> m_isCalibrationWanted{false};

    core::TripleBuffer<device::PlainCopy<device::DeviceState>> m_state; // I/O thread -> servo thread
    core::TripleBuffer<device::PlainCopy<ForceCommand>> m_push;         // servo thread -> I/O thread
    std::int64_t m_readState_ns = 0; // servo thread only: time stamp of the last state read

    // Written by the I/O thread for report().
    std::atomic<device::DeviceCondition> m_condition{device::DeviceCondition::Working};
    std::atomic<int> m_protocol{0};
    std::atomic<std::size_t> m_unexpectedLength{0};
    core::TimingHistogram m_latency;
};

} // namespace palpate::woodenhaptics
