// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PoseStream.h"
#include "SteppedHand.h"

#include <palpate/core/TripleBuffer.h>
#include <palpate/device/DevicePlugin.h>
#include <palpate/device/PlainCopy.h>
#include <palpate/igtl/Connection.h>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

namespace palpate::openigtlink {

/// Hand whose pose another program sends by OpenIGTLink, as device "openigtlink". An I/O thread keeps the connection to
/// the server, connects again after a loss, and exchanges the newest pose and force with the servo thread. With a
/// `force` in the settings, each pose is answered by the force on the hand as the translation of a transform.
class Driver final : public device::HapticDevice
{
  public:
    explicit Driver(Settings settings);
    ~Driver() override;

    [[nodiscard]] device::DeviceInfo info() const override;
    /// Fails if no server answers.
    core::Status start() override;
    void stop() noexcept override;
    [[nodiscard]] device::DeviceState read(std::int64_t now_ns) noexcept PALPATE_NONBLOCKING override;
    void write(const core::Vec3& f_D) noexcept PALPATE_NONBLOCKING override;
    /// `text` states the measured rate and its consequences for touch.
    [[nodiscard]] device::DeviceReport report() const override;
    /// With a workspace, makes the current position its centre.
    core::Status calibrate() override;

  private:
    /// Force command from the servo thread.
    struct ForceCommand
    {
        core::Vec3 f_D = core::Vec3::Zero(); ///< [N]
        std::int64_t answers_ns = 0;         ///< arrival of the sample that the hand has reached
        std::int64_t time_ns = 0;
    };

    [[nodiscard]] bool hasForce() const noexcept { return !m_settings.force.empty(); }
    void run(igtl::Socket first) noexcept;
    void serve(igtl::Connection& connection);
    void take(const igtl::Message& message);
    void loseHand(bool isLost) noexcept;
    [[nodiscard]] core::Vec3 wantedForce(std::int64_t now_ns) noexcept;
    void sendForce(igtl::Connection& connection, const core::Vec3& f_D);
    void noteProblem(const std::string& problem);

    const Settings m_settings;
    std::thread m_thread;
    std::atomic<bool> m_isStopWanted{false};
    std::atomic<bool> m_isCentreWanted{false};

    core::TripleBuffer<device::PlainCopy<Sample>> m_sample;     // I/O thread -> servo thread
    core::TripleBuffer<device::PlainCopy<ForceCommand>> m_push; // servo thread -> I/O thread

    // Servo thread only.
    SteppedHand m_hand;
    std::int64_t m_reached_ns = 0; ///< arrival of the newest sample that the hand has reached

    // I/O thread only.
    PoseStream m_stream;
    Sample m_newest;
    core::Vec3 m_centre_mm = core::Vec3::Zero();
    bool m_isAnswerDue = false; ///< a pose has arrived since the last force was sent
    std::int64_t m_answered_ns = 0;

    // Written by the I/O thread for report().
    std::atomic<bool> m_isConnected{false};
    std::atomic<std::int64_t> m_poseTime_ns{0};
    std::atomic<std::int64_t> m_interval_ns{0};
    std::atomic<std::uint64_t> m_states{0};
    std::atomic<std::uint64_t> m_refused{0};
    std::atomic<std::uint64_t> m_losses{0};
    core::TimingHistogram m_latency;
    mutable std::mutex m_mutex; ///< of the following; never locked by the servo thread
    std::string m_tool;
    std::string m_problem; ///< latest refused message
};

} // namespace palpate::openigtlink
