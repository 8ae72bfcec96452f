// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/servo/MotionTrack.h"

#include <palpate/core/Export.h>
#include <palpate/core/Realtime.h>
#include <palpate/core/Types.h>
#include <palpate/device/HapticDevice.h>

#include <array>
#include <cstddef>

namespace palpate::servo {

using core::Vec3;

/// Damping limits and sensor properties of a device for the passivity controller.
struct PALPATE_EXPORT PassivityLimits
{
    bool isOn = true;                    ///< false: observe only, without added damping
    double ownDamping_Ns_per_mm = 0.0;   ///< guaranteed damping of the device mechanics, without a hand
    double maxDamping_Ns_per_mm = 0.004; ///< bound on the added damping at 1 kHz and above; proportionally less below
    double resolution_mm = 0.0;          ///< sensor step per axis (error at most half a step); 0: exact
    int delayTicks = 1;                  ///< see PassivityController::setDelay

    /// Limits for a device. Without a stated damping limit, uses the limit of the weakest preset.
    [[nodiscard]] static PassivityLimits forDevice(const device::DeviceInfo& info) noexcept;
};

/// Observed energies and the damping of the current tick.
struct PassivityState
{
    double energy_mJ = 0.0;         ///< net energy from hand and moving tissue since contact began; < 0: the hand
                                    ///< received more
    double excess_mJ = 0.0;         ///< energy from sampling and delay that is not yet damped away, >= 0
    double damping_Ns_per_mm = 0.0; ///< added in this tick
};

/// Observes the energy that flows between program and hand, and dissipates the generated part by damping.
///
/// A sampled and delayed spring force returns more work to an oscillating hand than the hand puts in: a move d in one
/// tick generates (1/2 + delay) K d^2, the K T / 2 of the passivity bound b > K T / 2 + |B|. In every tick the observer
/// adds the work of the sent force, f_sent . dx, and subtracts the work of the ideal force (mean of the model's forces
/// before and after the move) and the energy b |dx|^2 / T that the device's own damping dissipates. The remainder, the
/// excess, requires the damping alpha = excess / (T v^2) to dissipate within one period. Energy that the hand receives
/// beyond its total input since contact began counts in the same way: a model can generate energy, for example when the
/// hand presses in on the soft side of a stiffness boundary and leaves on the stiff side.
///
/// The motion comes from a MotionTrack. A quantized sensor moves by a whole step or not at all; taking a step d as the
/// motion of one tick would add an excess of K d^2 / 2 and cause a force spike of up to d / T times the largest
/// damping. The controller dissipates an excess over the same number of ticks n as the window of the motion: alpha / n.
/// @par Source Hannaford & Ryu, IEEE Trans. Robotics and Automation 18 (2002) 1, doi:10.1109/70.988969 (observer and
/// controller in the time domain; alpha). The work of a held force: Ryu, Kim & Hannaford, IEEE Trans. Robotics 20
/// (2004) 772, doi:10.1109/TRO.2004.829453. Differs: the reference is the model's own work, so that energy stored in a
/// compressed spring does not mask generated energy; the damping is bounded by the limit of the device.
/// @par Real-time Wait-free, no allocation. One thread.
class PALPATE_EXPORT PassivityController
{
  public:
    static constexpr int kMaxDelayTicks = 16;
    /// @param dt_s  nominal period, > 0 [s]
    PassivityController(const PassivityLimits& limits, double dt_s) noexcept;

    /// Processes the HIP of a tick. Call before `damping`.
    /// @param p_WH  HIP in the world frame; a non-finite value resets the controller [mm]
    /// @return the motion of the hand; `slope` is also the velocity for tissue dampers
    const MotionTrack& follow(const Vec3& p_WH) noexcept PALPATE_NONBLOCKING;
    /// Computes the damping force of this tick.
    /// @param fAsked_W  force without added damping: the model's force after easing and limits [N]
    /// @return force to add to `fAsked_W`, opposed to the motion [N]
    [[nodiscard]] Vec3 damping(const Vec3& fAsked_W, bool isInContact) noexcept PALPATE_NONBLOCKING;
    /// Sets the delay from a position measurement to the resulting force, in ticks. Clamped to 0 to kMaxDelayTicks.
    void setDelay(int ticks) noexcept PALPATE_NONBLOCKING;
    /// Records the force sent in this tick, after all limits [N].
    void noteSent(const Vec3& fSent_W) noexcept PALPATE_NONBLOCKING;
    /// Adds the energy stored in the springs of a newly set scene, which no hand has put in [mJ].
    void noteStored(double energy_mJ) noexcept PALPATE_NONBLOCKING;
    /// Adds energy that moving tissue has put into the contacts since the last tick, < 0: taken out. The hand may get
    /// it back without damping. Call before `damping` [mJ].
    void noteWork(double work_mJ) noexcept PALPATE_NONBLOCKING { m_state.energy_mJ += work_mJ; }
    /// Discards all observations, for a new or absent hand.
    void reset() noexcept PALPATE_NONBLOCKING;

    [[nodiscard]] const PassivityState& state() const noexcept { return m_state; }

  private:
    PassivityLimits m_limits;
    double m_dt_s;
    PassivityState m_state;
    MotionTrack m_motion;
    Vec3 m_fAsked_W = Vec3::Zero();
    std::array<Vec3, kMaxDelayTicks + 1> m_sent_W; // newest first
};

/// Largest stiffness for which a sampled spring with a damper is passive for any motion: K = 2 (b - |B|) / T.
/// @param b_Ns_per_mm  damping of the device mechanics; @param B_Ns_per_mm  damping of the tissue
/// @par Source Colgate & Schenkel, J. Robotic Systems 14 (1997) 37 (b > K T / 2 + |B|).
[[nodiscard]] PALPATE_EXPORT double passiveStiffness_N_per_mm(double b_Ns_per_mm, double B_Ns_per_mm,
                                                              double dt_s) noexcept;

/// Largest stiffness for which a sampled spring with a delay of `delay_s` does not oscillate on a mass:
/// K = (b + B) / (T / 2 + delay), for damping much smaller than mass / T.
/// @par Source Hulin, Preusche & Hirzinger, IROS 2006, doi:10.1109/IROS.2006.282524 (linear stability condition).
[[nodiscard]] PALPATE_EXPORT double stableStiffness_N_per_mm(double damping_Ns_per_mm, double dt_s,
                                                             double delay_s) noexcept;

/// Largest stiffness that the program renders on a device: the manufacturer's value, but at most
///   0.7 (b + B) / (T / 2 + delay)
/// with the device's damping b and the guaranteed damping B of the controller. B is the smaller of the manufacturer's
/// limit and 10 N s/m. B decreases proportionally for periods above 1 ms and for sensors coarser than 0.04 mm, because
/// motion below the resolution is not damped. The values 0.7, 10 N s/m and 0.04 mm are fitted to stay below the closed
/// loop's stability limit for every preset at 250 Hz to 4 kHz and 0 to 4 ticks of delay; for the measurements see
/// docs/stability.md.
/// @param delayTicks  >= 0, for a running device from `delayTicksOf`
/// @return infinity for a device without motors, which cannot oscillate
[[nodiscard]] PALPATE_EXPORT double heldStiffness_N_per_mm(const device::DeviceInfo& info, double rate_Hz,
                                                           bool isControlled, int delayTicks = 1) noexcept;

/// Delay of the device's force: the 99th percentile of the response latency in whole ticks, at least 1.
/// @param latency  of the device, see DeviceReport; returns 1 for fewer than 1,000 samples
[[nodiscard]] PALPATE_EXPORT int delayTicksOf(const core::TimingSummary& latency, double rate_Hz) noexcept;

} // namespace palpate::servo
