// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/TripleBuffer.h>
#include <palpate/device/HapticDevice.h>
#include <palpate/device/PlainCopy.h>

#include <cstdint>

namespace palpate::vendor {

/// Exchanges the newest state and the newest force between the thread that serves a device and the servo thread. A
/// force that the servo thread does not renew expires after 8 ms, so that zero is on its way to the device within 10
/// ms.
class HandExchange
{
  public:
    /// Forgets state, force and latency. Neither thread is running.
    void reset();

    /// @name Servo thread
    /// @par Real-time Wait-free.
    ///@{
    [[nodiscard]] device::DeviceState read() noexcept PALPATE_NONBLOCKING;
    void write(const core::Vec3& f_D) noexcept PALPATE_NONBLOCKING;
    ///@}

    /// @name Thread that serves the device
    /// @par Real-time Wait-free.
    ///@{
    void publish(const device::DeviceState& state) noexcept PALPATE_NONBLOCKING;
    /// Returns the newest force, at most `maxForce_N` long; zero if it has expired or is not finite [N].
    [[nodiscard]] core::Vec3 wantedForce(std::int64_t now_ns, double maxForce_N) noexcept PALPATE_NONBLOCKING;
    /// The force `f_D` of `wantedForce` has been handed to the device: measures the latency.
    void noteSent(const core::Vec3& f_D, std::int64_t now_ns) noexcept PALPATE_NONBLOCKING;
    ///@}

    /// Time from a state to the force that answers it. Any thread.
    [[nodiscard]] core::TimingSummary latency() const { return m_latency.summary(); }

  private:
    /// Force command from the servo thread.
    struct ForceCommand
    {
        core::Vec3 f_D = core::Vec3::Zero(); ///< [N]
        std::int64_t answers_ns = 0;         ///< time stamp of the state from which the force was computed
        std::int64_t time_ns = 0;
    };

    core::TripleBuffer<device::PlainCopy<device::DeviceState>> m_state; // to the servo thread
    core::TripleBuffer<device::PlainCopy<ForceCommand>> m_push;         // from the servo thread
    std::int64_t m_readState_ns = 0; // servo thread only: time stamp of the last state read
    std::int64_t m_answered_ns = 0;  // thread of the device only: of the last state that was answered
    core::TimingHistogram m_latency;
};

} // namespace palpate::vendor
