// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/servo/Fault.h"

#include <palpate/core/Export.h>
#include <palpate/device/HapticDevice.h>

#include <cstdint>

namespace palpate::servo {

using core::Vec3;

/// Handling of a HIP step that is too large for a hand.
enum class JumpRule : std::uint8_t
{
    Refuse, ///< keep the last valid HIP; fault if it persists. For encoders, which jump only on an error.
    Follow, ///< follow at hand speed. For pointers, which can be anywhere at the next event.
};

/// Limits of the safety gate.
struct PALPATE_EXPORT GateLimits
{
    double maxForce_N = 0.0;                ///< force limit of the device; 0: no force passes
    double maxForceRate_N_per_s = 0.0;      ///< bound on the force change per second, except at first contact
    double maxPower_Nmm_per_s = 0.0;        ///< bound on the power delivered to the hand, f . v
    double maxHandSpeed_mm_per_s = 10000.0; ///< faster than a throw; 10 mm in a tick of 1 ms
    JumpRule jumpRule = JumpRule::Refuse;
    std::uint32_t refusedRun = 5;  ///< consecutive refused HIPs that raise a fault
    std::uint32_t overrunRun = 20; ///< consecutive overruns that raise a fault, like libfranka's lost packets; 0: never
    double staleAfter_s = 0.005;   ///< HIP age that raises a fault
    double easeIn_s = 0.5;         ///< easing time at start, after a fault and when the hand returns
    double rampDown_s =
        0.008; ///< ramp to zero on stop and fault, in tick time: below 10 ms including one tick of detection
    double largestCoordinate_mm = 1e8; ///< larger coordinates exceed the model's numeric precision
    double workspaceRadius_mm = 0.0;   ///< around the origin of D; positions outside are refused; 0: unlimited

    /// Limits for a device: the device's force, a rise to this force within 5 ms, the power of this force at 1 m/s,
    /// and 1.5 times the workspace. A device without motors cannot push, so that jumps are followed and overruns raise
    /// no fault.
    [[nodiscard]] static GateLimits forDevice(const device::DeviceInfo& info);
};

/// Input for the model after the gate.
struct GatedInput
{
    Vec3 p_D = Vec3::Zero(); ///< HIP, finite; the last valid HIP when the measured HIP was refused [mm]
    bool isPresent = false;  ///< false: no hand, nothing to solve
    bool isGated = false;    ///< the measured HIP was changed or refused
    bool isFirst = false;    ///< the hand arrived or the fault was re-armed: contacts restart here
};

/// Force requested by the model.
struct ForceRequest
{
    Vec3 f_D = Vec3::Zero(); ///< any value, including non-finite [N]
    bool isInContact = false;
    bool isSceneChanged = false; ///< first tick on another scene: a contact that begins now is no first contact
};

/// Bounds every HIP and every force between device and model, and ensures that both are finite. Call `admit`, then
/// `release` once per tick; a pure state machine without a clock.
///
/// In every tick the force from `release` is:
/// - finite, and at most `maxForce_N` long;
/// - within `maxForceRate_N_per_s` of the previous tick, except in the tick in which contact begins from (nearly) zero
///   force on an unchanged scene, so that a wall is rendered in the tick of impact;
/// - within the power bound, which only reduces the force and takes precedence over the rate bound;
/// - growing from zero over `easeIn_s` when the hand arrives, at start and after `rearm`;
/// - zero immediately without a hand, and after `rampDown_s` on stop or fault, until re-armed.
/// @par Real-time Wait-free, no allocation. One thread.
class PALPATE_EXPORT SafetyGate
{
  public:
    /// @param dt_s  nominal period, > 0 [s]
    SafetyGate(const GateLimits& limits, double dt_s) noexcept;

    [[nodiscard]] GatedInput admit(const device::DeviceState& state, std::int64_t now_ns) noexcept PALPATE_NONBLOCKING;
    /// @return force for the device in frame D [N]
    [[nodiscard]] Vec3 release(const ForceRequest& request) noexcept PALPATE_NONBLOCKING;

    /// Model force in `release` before the rate and power bounds: eased in and limited to the device's maximum [N].
    [[nodiscard]] Vec3 eased(const Vec3& f_D) const noexcept PALPATE_NONBLOCKING;

    /// Counts late ticks. Call once per tick.
    void noteOverrun(bool isOverrun) noexcept PALPATE_NONBLOCKING;
    /// Latches `kind` unless another fault is latched; the force ramps to zero.
    void raise(FaultKind kind) noexcept PALPATE_NONBLOCKING;
    /// Clears the fault. The force is eased in, and the next HIP is accepted at any position.
    void rearm() noexcept PALPATE_NONBLOCKING;
    /// Eases the force in as at the start, after a clutch was released.
    void restartEaseIn() noexcept PALPATE_NONBLOCKING;
    /// Ramps the force to zero permanently.
    void beginStop() noexcept PALPATE_NONBLOCKING;

    [[nodiscard]] FaultKind fault() const noexcept { return m_fault; }
    /// @return true when the force is zero and stays zero until re-armed.
    [[nodiscard]] bool isAtRest() const noexcept;
    [[nodiscard]] const GateLimits& limits() const noexcept { return m_limits; }

  private:
    void refuse(FaultKind kind) noexcept;
    [[nodiscard]] double nextGain() const noexcept;

    GateLimits m_limits;
    double m_dt_s;
    FaultKind m_fault = FaultKind::None;
    bool m_isStopping = false;
    bool m_hasHand = false;   // m_p_D is an accepted HIP
    bool m_isPresent = false; // in this tick
    bool m_wasInContact = false;
    std::uint32_t m_refused = 0;  // consecutive
    std::uint32_t m_overruns = 0; // consecutive
    double m_rampLeft_s = 0.0;    // remaining time of the ramp
    double m_passed_s = 0.0;      // since the previous tick, at least one period
    std::int64_t m_now_ns = 0;
    double m_gain = 0.0;
    std::int64_t m_time_ns = 0; // of the last accepted HIP
    Vec3 m_p_D = Vec3::Zero();
    Vec3 m_v_D = Vec3::Zero();    // [mm/s]
    Vec3 m_sent_D = Vec3::Zero(); // in the previous tick
};

} // namespace palpate::servo
