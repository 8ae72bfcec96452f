// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Session.h"

#include <palpate/core/TripleBuffer.h>
#include <palpate/device/PlainCopy.h>

#include <atomic>
#include <thread>

namespace palpate::haply {

/// Reason why a connected device does not work as a hand.
enum class Trouble : std::uint8_t
{
    None,
    Starting, ///< state not known yet
    NoPower,  ///< connected by USB only
    NotCalibrated,
    NotReady,
    OtherAxes, ///< the service turns, scales or moves positions, although it was asked not to
};

/// Haply device as device "haply". An I/O thread exchanges messages with the Inverse Service: a force for a state, one
/// at a time, up to 4000 times a second. After a loss the driver connects to the same device again.
class Driver final : public device::HapticDevice
{
  public:
    /// @param deviceId  identifier of the device to open; empty: the only device
    Driver(Settings settings, std::string deviceId);
    ~Driver() override;

    /// Limits of the device if the service had it at construction; otherwise cautious limits until `start`.
    [[nodiscard]] device::DeviceInfo info() const override;
    core::Status start() override;
    void stop() noexcept override;
    [[nodiscard]] device::DeviceState read(std::int64_t now_ns) noexcept PALPATE_NONBLOCKING override;
    void write(const core::Vec3& f_D) noexcept PALPATE_NONBLOCKING override;
    [[nodiscard]] device::DeviceReport report() const override;
    /// Refuses with instructions: the service calibrates.
    core::Status calibrate() override;

  private:
    /// Force command from the servo thread.
    struct ForceCommand
    {
        core::Vec3 f_D = core::Vec3::Zero(); ///< [N]
        std::int64_t answers_ns = 0;         ///< time stamp of the state from which the force was computed
        std::int64_t time_ns = 0;
    };

    /// Takes identity and limits of a device.
    void adopt(const Session& session);

    // I/O thread.
    void run(std::unique_ptr<Session> session) noexcept;
    void serve(Session& session);
    [[nodiscard]] std::unique_ptr<Session> reopen() noexcept;
    /// Sends the next message, if one is due. @return false: the service has been silent for too long
    [[nodiscard]] bool pushNext(Session& session, std::int64_t now_ns);
    void take(const Update& update, std::int64_t asked_ns, std::int64_t now_ns) noexcept;
    /// Compares the force that the service drives with the force that was sent.
    void checkFollowing(Session& session, const Update& update, std::int64_t now_ns) noexcept;
    [[nodiscard]] core::Vec3 wantedForce(std::int64_t now_ns) noexcept;
    void publish(bool isPresent, bool isLost) noexcept;

    Settings m_settings;
    std::string m_deviceId;
    std::string m_type; ///< written before the thread starts, as the next three
    Model m_model;
    bool m_hasGrip = false;
    bool m_isGripUndecided = false;
    std::thread m_thread;
    std::atomic<bool> m_isStopWanted{false};

    core::TripleBuffer<device::PlainCopy<device::DeviceState>> m_state; // I/O thread -> servo thread
    core::TripleBuffer<device::PlainCopy<ForceCommand>> m_push;         // servo thread -> I/O thread
    std::int64_t m_readState_ns = 0; // servo thread only: time stamp of the last state read

    // I/O thread only.
    device::DeviceState m_sensed;
    core::Vec3 m_sent_N = core::Vec3::Zero();
    Axes m_axes = Axes::Unstated;
    bool m_isSilenced = false; ///< zero was sent because no answer came
    bool m_isKeySwitched = false;
    std::int64_t m_began_ns = 0;      ///< of the session
    std::int64_t m_askedAll_ns = 0;   ///< for a full message
    std::int64_t m_sensed_ns = 0;     ///< last valid state received
    std::int64_t m_awayUntil_ns = 0;  ///< no hand is reported, so that the force is eased in afterwards
    std::int64_t m_unfollowed_ns = 0; ///< begin of the time without a driven force; 0: the service follows
    std::int64_t m_answered_ns = 0;

    // Written by the I/O thread for report().
    std::atomic<bool> m_isLost{false};
    std::atomic<bool> m_isShared{false};
    std::atomic<bool> m_isUnfollowed{false};
    std::atomic<Trouble> m_trouble{Trouble::Starting};
    std::atomic<std::uint64_t> m_states{0};
    std::atomic<std::uint64_t> m_refused{0};
    std::atomic<std::uint64_t> m_losses{0};
    core::TimingHistogram m_latency;
};

} // namespace palpate::haply
