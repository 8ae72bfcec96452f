// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/servo/Fault.h"

#include <palpate/device/HapticDevice.h>

#include <cstdint>

namespace palpate::servo {

using core::Vec3;

/// What to do with a HIP that moved farther than a hand can.
enum class JumpRule : std::uint8_t
{
    Refuse, ///< keep the last good HIP; a fault when it goes on. For encoders, which never jump but by an error.
    Follow, ///< go there at the speed of a hand. For pointers, which may be anywhere at the next event.
};

/// The limits of the safety gate, all of them data.
struct GateLimits
{
    double maxForce_N = 0.0;                ///< of the device; 0: no force ever passes
    double maxForceRate_N_per_s = 0.0;      ///< bound on the change of the force, but for first contact
    double maxPower_Nmm_per_s = 0.0;        ///< bound on the power given to the hand, f . v
    double maxHandSpeed_mm_per_s = 10000.0; ///< faster than a throw; 10 mm in a tick of 1 ms
    JumpRule jumpRule = JumpRule::Refuse;
    std::uint32_t refusedRun = 5;  ///< refused HIPs in a row that make a fault
    std::uint32_t overrunRun = 20; ///< overruns in a row that make a fault, as libfranka's lost packets; 0: never
    double staleAfter_s = 0.005;   ///< age of a HIP that makes a fault
    double easeIn_s = 0.5;         ///< at start, after a fault and when the hand comes back
    double rampDown_s = 0.008; ///< to zero on stop and fault, by the clock of the ticks: below 10 ms with one to notice
    double largestCoordinate_mm = 1e8; ///< beyond it the model's arithmetic has no digits left
    double workspaceRadius_mm = 0.0;   ///< about the origin of D; farther away is refused; 0: not limited

    /// Limits for a device: its force; its force within 5 ms; its force at 1 m/s; half again its workspace. A device
    /// without motors cannot push, so its jumps are followed and overruns make no fault.
    [[nodiscard]] static GateLimits forDevice(const device::DeviceInfo& info);
};

/// What the gate lets through to the model.
struct GatedInput
{
    Vec3 p_D = Vec3::Zero(); ///< HIP, finite; the last good one when the measured one was refused [mm]
    bool isPresent = false;  ///< false: no hand, solve nothing
    bool isGated = false;    ///< the measured HIP was changed or refused
    bool isFirst = false;    ///< the hand came, or the fault was re-armed: contacts begin anew here
};

/// The force that the model asks for.
struct ForceRequest
{
    Vec3 f_D = Vec3::Zero(); ///< [N], of any value
    bool isInContact = false;
    bool isSceneChanged = false; ///< first tick on another scene: a contact that begins now is no first contact
};

/// Stands between device and model in both directions: each HIP and each force that it lets through is finite and
/// bounded. Once a tick `admit`, then `release`; a pure state machine without a clock of its own.
///
/// The force that `release` gives is, in every tick:
/// - finite, and no longer than `maxForce_N`;
/// - within `maxForceRate_N_per_s` of the tick before, except in the tick in which contact begins from (nearly) no
///   force on an unchanged scene: a wall must be felt in the tick it is hit;
/// - within the power bound, which only ever takes force away and wins over the bound on change;
/// - growing from zero over `easeIn_s` when the hand comes, at start and after `rearm`;
/// - zero at once without a hand, and after `rampDown_s` on stop or fault, until re-armed.
/// @par Real-time Wait-free, no allocation. One thread.
class SafetyGate
{
  public:
    /// @param dt_s  nominal period, > 0 [s]
    SafetyGate(const GateLimits& limits, double dt_s) noexcept;

    [[nodiscard]] GatedInput admit(const device::DeviceState& state, std::int64_t now_ns) noexcept PALPATE_NONBLOCKING;
    /// @return force for the device in frame D [N]
    [[nodiscard]] Vec3 release(const ForceRequest& request) noexcept PALPATE_NONBLOCKING;

    /// The model's force as `release` has it before it bounds change and power: eased in, and no longer than
    /// the device can. [N]
    [[nodiscard]] Vec3 eased(const Vec3& f_D) const noexcept PALPATE_NONBLOCKING;

    /// Counts ticks that ended late, once a tick.
    void noteOverrun(bool isOverrun) noexcept PALPATE_NONBLOCKING;
    /// Latches `kind` unless another fault is; the force ramps to zero.
    void raise(FaultKind kind) noexcept PALPATE_NONBLOCKING;
    /// Unlatches the fault; force is eased in anew, and the next HIP is taken as it comes.
    void rearm() noexcept PALPATE_NONBLOCKING;
    /// A clutch was let go: the coming force is eased in as at the start.
    void easeInAnew() noexcept PALPATE_NONBLOCKING;
    /// Ramps the force to zero for good.
    void beginStop() noexcept PALPATE_NONBLOCKING;

    [[nodiscard]] FaultKind fault() const noexcept { return m_fault; }
    /// The force is zero and stays so until re-armed.
    [[nodiscard]] bool isAtRest() const noexcept;
    [[nodiscard]] const GateLimits& limits() const noexcept { return m_limits; }

  private:
    void refuse(FaultKind kind) noexcept;
    [[nodiscard]] double nextGain() const noexcept;

    GateLimits m_limits;
    double m_dt_s;
    FaultKind m_fault = FaultKind::None;
    bool m_isStopping = false;
    bool m_hasHand = false;   // m_p_D is a good HIP
    bool m_isPresent = false; // in this tick
    bool m_wasInContact = false;
    std::uint32_t m_refused = 0;  // in a row
    std::uint32_t m_overruns = 0; // in a row
    double m_rampLeft_s = 0.0;    // of the ramp still to come
    double m_passed_s = 0.0;      // since the tick before, at least a period
    std::int64_t m_now_ns = 0;
    double m_gain = 0.0;
    std::int64_t m_time_ns = 0; // of the last good HIP
    Vec3 m_p_D = Vec3::Zero();
    Vec3 m_v_D = Vec3::Zero();    // [mm/s]
    Vec3 m_sent_D = Vec3::Zero(); // in the tick before
};

} // namespace palpate::servo
