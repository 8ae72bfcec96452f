// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/servo/MotionTrack.h"

#include <palpate/core/Realtime.h>
#include <palpate/core/Types.h>
#include <palpate/device/HapticDevice.h>

#include <array>
#include <cstddef>

namespace palpate::servo {

using core::Vec3;

/// What the passivity controller may assume of a device and do to it.
struct PassivityLimits
{
    bool isOn = true;                    ///< false: observes, adds nothing
    double ownDamping_Ns_per_mm = 0.0;   ///< that the device's mechanics are sure to have, without a hand
    double maxDamping_Ns_per_mm = 0.004; ///< adds no more than this at 1 kHz and above, in proportion below
    double resolution_mm = 0.0;          ///< an axis' position is off by at most half of it; 0: exact
    int delayTicks = 1;                  ///< see PassivityController::setDelay

    /// Of a device; where it states no damping it can take, that of the weakest preset.
    [[nodiscard]] static PassivityLimits forDevice(const device::DeviceInfo& info) noexcept;
};

/// What the observer saw.
struct PassivityState
{
    double energy_mJ = 0.0;         ///< that the hand put in since contact began and has not got back; < 0: it got more
    double excess_mJ = 0.0;         ///< that sampling and delay made and that is not damped away yet, >= 0
    double damping_Ns_per_mm = 0.0; ///< added in this tick
};

/// Watches the energy that passes between program and hand, and takes away by damping the part that should not be
/// there.
///
/// A force that is held for a period, and acts a little late, gives a hand that moves back and forth on a spring more
/// work than it took: a motion of d in a tick makes (1/2 + delay) K d^2 too much, the K T / 2 of the passivity bound
/// b > K T / 2 + |B|. The observer adds up, tick by tick, the work of the force that really acted, f_sent . dx, less
/// that of the force that should have, the mean of the model's forces before and after the move. What the device's own
/// damping takes away, b |dx|^2 / T, is subtracted. The rest, the excess, asks for the damping
/// alpha = excess / (T v^2), which would take it away in one period. So does what the hand got back beyond all that it
/// put in since contact began: a model can make energy too, as a border between soft and stiff does for a hand that
/// presses in on the soft side and comes out on the stiff one.
///
/// Motion is that of a MotionTrack: a sensor that counts in steps moves a step in a tick or not at all, and a step d
/// answered as a motion of one tick would make an excess of K d^2 / 2 and ask for a jerk of up to d / T times the
/// largest damping. An excess is damped away over as many ticks as the motion was measured over, n: alpha / n.
/// @par Source Hannaford & Ryu, IEEE Trans. Robotics and Automation 18 (2002) 1, doi:10.1109/70.988969 (observer and
/// controller in the time domain; alpha). The work of a held force: Ryu, Kim & Hannaford, IEEE Trans. Robotics 20
/// (2004) 772, doi:10.1109/TRO.2004.829453. Differs: measured against the model's own work, so that energy stored in a
/// pressed spring does not hide what sampling makes, and the damping is bounded by what the device can take.
/// @par Real-time Wait-free, no allocation. One thread.
class PassivityController
{
  public:
    static constexpr int kLongestDelay = 16;
    /// @param dt_s  nominal period, > 0 [s]
    PassivityController(const PassivityLimits& limits, double dt_s) noexcept;

    /// Takes the HIP of a tick, before `damping`.
    /// @param p_WH  [mm]; one that is not finite resets
    /// @return the hand's motion; its `slope` is the velocity for a tissue's dampers, too
    const MotionTrack& follow(const Vec3& p_WH) noexcept PALPATE_NONBLOCKING;
    /// The damping of this tick.
    /// @param fAsked_W  what would be sent without it: the model's force, eased in and bounded [N]
    /// @return force to add to `fAsked_W` [N], against the motion
    [[nodiscard]] Vec3 damping(const Vec3& fAsked_W, bool isInContact) noexcept PALPATE_NONBLOCKING;
    /// Says how late a force acts: so many ticks after the position that it answers was measured, 0 to kLongestDelay,
    /// to which a longer delay is cut.
    void setDelay(int ticks) noexcept PALPATE_NONBLOCKING;
    /// Says which force was sent in the tick, after every bound.
    void noteSent(const Vec3& fSent_W) noexcept PALPATE_NONBLOCKING;
    /// Another scene was put under the hand: its springs hold this much without anyone having pressed them. [mJ]
    void noteStored(double energy_mJ) noexcept PALPATE_NONBLOCKING;
    /// The hand is new or away: forgets what was observed.
    void reset() noexcept PALPATE_NONBLOCKING;

    [[nodiscard]] const PassivityState& state() const noexcept { return m_state; }

  private:
    PassivityLimits m_limits;
    double m_dt_s;
    PassivityState m_state;
    MotionTrack m_motion;
    Vec3 m_fAsked_W = Vec3::Zero();
    std::array<Vec3, kLongestDelay + 1> m_sent_W; // newest first
};

/// The stiffness up to which a sampled spring with a damper is passive whatever the hand does: K = 2 (b - |B|) / T.
/// @param b_Ns_per_mm  of the device's mechanics; @param B_Ns_per_mm  of the tissue
/// @par Source Colgate & Schenkel, J. Robotic Systems 14 (1997) 37 (b > K T / 2 + |B|).
[[nodiscard]] double passiveStiffness_N_per_mm(double b_Ns_per_mm, double B_Ns_per_mm, double dt_s) noexcept;

/// The stiffness up to which a sampled spring that acts `delay_s` late does not oscillate on a mass:
/// K = (b + B) / (T / 2 + delay), for damping that is small beside mass / T.
/// @par Source Hulin, Preusche & Hirzinger, IROS 2006, doi:10.1109/IROS.2006.282524 (linear stability condition).
[[nodiscard]] double stableStiffness_N_per_mm(double damping_Ns_per_mm, double dt_s, double delay_s) noexcept;

/// The stiffness that the program lets a device hold: what its maker states, and no more than
///   0.7 (b + B) / (T / 2 + delay)
/// with b the device's damping and B what the controller is sure to add, the smaller of the maker's most and 10 N s/m;
/// at longer periods than 1 ms less in proportion, and so for sensors coarser than 0.04 mm, since what they do not tell
/// is not damped. 0.7, 10 N s/m and 0.04 mm are fitted, below what the closed loop held for every preset at 250 Hz to 4
/// kHz and 0 to 4 ticks of delay; resources/docs/stability.md says what that was.
/// @param delayTicks  >= 0, as delayTicksOf says of a running device
/// @return no bound (infinite) for a device without motors, which cannot oscillate
[[nodiscard]] double heldStiffness_N_per_mm(const device::DeviceInfo& info, double rate_Hz, bool isControlled,
                                            int delayTicks = 1) noexcept;

/// How late a device's force acts: the time that 99 of 100 answers took, in whole ticks, at least 1.
/// @param latency  of the device, see DeviceReport; below a thousand answers it says nothing yet, and 1 is taken
[[nodiscard]] int delayTicksOf(const core::TimingSummary& latency, double rate_Hz) noexcept;

} // namespace palpate::servo
