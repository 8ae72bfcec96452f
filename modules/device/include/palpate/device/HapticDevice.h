// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Realtime.h>
#include <palpate/core/Status.h>
#include <palpate/core/TimingHistogram.h>
#include <palpate/core/Types.h>

#include <cstdint>
#include <string>
#include <type_traits>

namespace palpate::device {

using core::Vec3;

/// What a device can sense and drive, and its limits.
struct DeviceInfo
{
    std::string id;   ///< stable, for settings and recordings: "mouse", "simulated-hand", "playback"
    std::string name; ///< for a person
    bool sensesOrientation = false;
    int buttons = 0;
    int actuatedAxes = 0;    ///< 0: feels nothing, the window shows the force instead
    double maxForce_N = 0.0; ///< the safety gate bounds every force by it
    double maxStiffness_N_per_mm = 0.0;
    double maxDamping_Ns_per_mm = 0.0;
    double ownDamping_Ns_per_mm = 0.0; ///< viscous, of its mechanics without a hand; 0: not known
    double resolution_mm = 0.0;        ///< a measured coordinate of the tip is off by at most half of it; 0: not known
    double workspaceRadius_mm = 0.0;   ///< about the origin of D; 0: not limited, and D is the world frame
    /// How D lies before the user, U: x to the right, y up, z towards the user; for mapping the device into the scene.
    core::Quaternion q_UD = core::Quaternion::Identity();
    double rate_Hz = 1000.0; ///< that the device itself works at
    /// Its pose is a speed, integrated: it has no edge to run into, and `calibrate` makes where it is now its origin.
    bool isRateControlled = false;
};

/// The newest state of a device.
struct DeviceState
{
    Vec3 p_D = Vec3::Zero();                             ///< tip [mm]; for built-in devices D is the world frame
    core::Quaternion q_D = core::Quaternion::Identity(); ///< orientation, unit
    std::uint32_t buttons = 0;                           ///< a bit each
    std::int64_t time_ns = 0; ///< monotonic, when it was measured; the safety gate fails it to zero force when stale
    bool isPresent = false;   ///< false: nothing measured yet, the hand let go, or the device is lost
    bool isLost = false;      ///< true: the device itself no longer answers (unplugged); latched as a fault
};
static_assert(std::is_trivially_destructible_v<DeviceState>); // crosses threads in a PlainCopy

/// Whether a started device can be felt with.
enum class DeviceCondition : std::uint8_t
{
    Working,
    NeedsCalibration, ///< its sensors count, but not from a known pose; no hand is reported until `calibrate`
    Lost,             ///< does not answer; works on by itself when it comes back
};

/// How a device is doing, for a person.
struct DeviceReport
{
    DeviceCondition condition = DeviceCondition::Working;
    std::string text;            ///< one line: what is the matter and what to do; empty: nothing to tell
    core::TimingSummary latency; ///< from a state received to the force that answers it written; count 0: not measured
    std::uint64_t states = 0;    ///< received
    std::uint64_t refused = 0;   ///< received, but not to be believed
    std::uint64_t losses = 0;    ///< times that it was lost
};

/// A device that senses a hand and may push back. A driver whose I/O can block runs a thread of its own behind this
/// interface and only exchanges its newest state and force here.
class HapticDevice
{
  public:
    virtual ~HapticDevice() = default;

    [[nodiscard]] virtual DeviceInfo info() const = 0;
    /// Opens the device. Any thread but the servo thread, before the first tick.
    virtual core::Status start() = 0;
    /// Lets go, with zero force. Any thread but the servo thread, after the last tick.
    virtual void stop() noexcept = 0;

    /// Gives the newest state.
    /// @param now_ns  monotonic time of this tick; scripted devices advance by the tick, never by this
    /// @par Real-time Wait-free. Servo thread, once a tick.
    [[nodiscard]] virtual DeviceState read(std::int64_t now_ns) noexcept PALPATE_NONBLOCKING = 0;
    /// Takes the force on the hand in frame D, already bounded by the safety gate [N].
    /// @par Real-time Wait-free. Servo thread, once a tick, after `read`.
    virtual void write(const Vec3& f_D) noexcept PALPATE_NONBLOCKING = 0;

    /// Tells how the device is doing. Any thread but the servo thread.
    [[nodiscard]] virtual DeviceReport report() const { return {}; }
    /// Takes the pose that the device is in now as its calibration pose. Any thread but the servo thread; returns at
    /// once, `report` tells when it is done.
    virtual core::Status calibrate() { return {core::StatusCode::Unsupported, "This device needs no calibration."}; }

    HapticDevice() = default;
    HapticDevice(const HapticDevice&) = delete;
    HapticDevice& operator=(const HapticDevice&) = delete;
};

} // namespace palpate::device
