// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Realtime.h>
#include <palpate/core/Status.h>
#include <palpate/core/TimingHistogram.h>
#include <palpate/core/Types.h>

#include <cstdint>
#include <string>
#include <type_traits>

namespace palpate::device {

using core::Vec3;

/// Capabilities and limits of a device.
struct DeviceInfo
{
    std::string id;   ///< stable identifier for settings and recordings: "mouse", "simulated-hand", "playback"
    std::string name; ///< display name
    bool sensesOrientation = false;
    int buttons = 0;
    int actuatedAxes = 0;    ///< 0: no force feedback, the window displays the force instead
    double maxForce_N = 0.0; ///< force limit enforced by the safety gate
    double maxStiffness_N_per_mm = 0.0;
    double maxDamping_Ns_per_mm = 0.0;
    double ownDamping_Ns_per_mm = 0.0; ///< viscous damping of the mechanics without a hand; 0: unknown
    double resolution_mm = 0.0;        ///< sensor resolution; tip positions are accurate to half of this; 0: unknown
    double workspaceRadius_mm = 0.0;   ///< around the origin of D; 0: unlimited, and D is the world frame
    /// Orientation of D relative to the user frame U (x right, y up, z towards the user), for mapping the device into
    /// the scene.
    core::Quaternion q_UD = core::Quaternion::Identity();
    double rate_Hz = 1000.0; ///< internal update rate of the device
    /// Rate control: the pose is an integrated velocity without workspace limits, and `calibrate` resets the origin to
    /// the current pose.
    bool isRateControlled = false;
};

/// Latest state of a device.
struct DeviceState
{
    Vec3 p_D = Vec3::Zero(); ///< tip position [mm]; for built-in devices D is the world frame
    core::Quaternion q_D = core::Quaternion::Identity(); ///< orientation, unit quaternion
    std::uint32_t buttons = 0;                           ///< one bit per button
    std::int64_t time_ns = 0; ///< monotonic time of the measurement; the safety gate sets the force to zero if stale
    bool isPresent = false;   ///< false: no measurement yet, hand released, or device lost
    bool isLost = false;      ///< true: the device no longer responds (unplugged); latched as a fault
};
static_assert(std::is_trivially_destructible_v<DeviceState>); // crosses threads in a PlainCopy

/// Operating condition of a started device.
enum class DeviceCondition : std::uint8_t
{
    Working,
    NeedsCalibration, ///< encoders count from an unknown pose; no hand is reported until `calibrate`
    Lost,             ///< no response; recovers automatically on reconnection
};

/// Device diagnostics for the user.
struct DeviceReport
{
    DeviceCondition condition = DeviceCondition::Working;
    std::string text;            ///< one line with problem and remedy; empty if there is no problem
    core::TimingSummary latency; ///< time from receiving a state to sending the resulting force; count 0: not measured
    std::uint64_t states = 0;    ///< number of received states
    std::uint64_t refused = 0;   ///< number of received states rejected as implausible
    std::uint64_t losses = 0;    ///< number of connection losses
};

/// Interface of a device that senses a hand and may apply forces. A driver with blocking I/O runs its own thread and
/// only exchanges the newest state and force in `read` and `write`.
class PALPATE_EXPORT HapticDevice
{
  public:
    virtual ~HapticDevice() = default;

    [[nodiscard]] virtual DeviceInfo info() const = 0;
    /// Opens the device. Any thread except the servo thread, before the first tick.
    virtual core::Status start() = 0;
    /// Sets zero force and closes the device. Any thread except the servo thread, after the last tick.
    virtual void stop() noexcept = 0;

    /// Returns the newest state.
    /// @param now_ns  monotonic time of this tick; scripted devices ignore the clock and advance once per call
    /// @par Real-time Wait-free. Servo thread, once per tick.
    [[nodiscard]] virtual DeviceState read(std::int64_t now_ns) noexcept PALPATE_NONBLOCKING = 0;
    /// Sends the force on the hand in frame D, already limited by the safety gate [N].
    /// @par Real-time Wait-free. Servo thread, once per tick, after `read`.
    virtual void write(const Vec3& f_D) noexcept PALPATE_NONBLOCKING = 0;

    /// Returns diagnostics. Any thread except the servo thread.
    [[nodiscard]] virtual DeviceReport report() const { return {}; }
    /// Starts a calibration at the current pose of the device and returns immediately; `report` shows the completion.
    /// Any thread except the servo thread.
    virtual core::Status calibrate()
    {
        return {core::StatusCode::Unsupported, PALPATE_TEXT("This device needs no calibration.")};
    }

    HapticDevice() = default;
    HapticDevice(const HapticDevice&) = delete;
    HapticDevice& operator=(const HapticDevice&) = delete;
};

} // namespace palpate::device
