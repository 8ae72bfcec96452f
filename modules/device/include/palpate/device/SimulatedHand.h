// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/device/DevicePresets.h"
#include "palpate/device/HandScript.h"
#include "palpate/device/HapticDevice.h"

#include <array>
#include <atomic>
#include <cstddef>

namespace palpate::device {

/// How a simulated hand holds a simulated device. The defaults stand for a light, well damped grip (0.7 of critical
/// damping at 11 Hz); they are a choice within what grips do, not a measurement.
struct SimulatedHandOptions
{
    DevicePreset preset = *findDevicePreset("touch"); ///< limits of the held device
    double rate_Hz = 1000.0;                          ///< of the servo loop; each tick advances the hand by 1 / rate_Hz
    double mass_kg = 0.1;                             ///< fingers and device as felt at the tip
    double gripStiffness_N_per_mm = 0.5;              ///< pulls the tip to the script's target
    double gripDamping_Ns_per_mm = 0.01;              ///< between the tip's velocity and the target's
    double deviceDamping_Ns_per_mm = 0.0005;          ///< the device's own friction, as a damper to the ground
    double friction_N = 0.0;                          ///< the device's Coulomb friction
    double resolution_mm = 0.0;                       ///< positions are read in steps of this, as encoders do; 0: exact
    int delayTicks = 0;                               ///< a force acts this many ticks after it was written, 0 to 16
    int subSteps = 20;                                ///< integration steps a tick, >= 1
    bool isRigid = false;                             ///< follows the script exactly and feels no force
};

/// A hand that follows a script and feels the force, "simulated-hand": a mass drawn to the script's target by a spring
/// and a damper, pushed by the force that was last written:
///   m a = k (p_target - p) + b (v_target - v) - b_device v + f - friction,
/// integrated with semi-implicit Euler; Coulomb friction takes away at most the speed that there is, so that the tip
/// sticks. Advances by one servo period a `read`, never by the clock: the same script and
/// forces give the same bits. D is the world frame, and the device is taken along wherever the script goes, so that
/// its workspace does not bind.
class SimulatedHand final : public HapticDevice
{
  public:
    explicit SimulatedHand(HandScript script, const SimulatedHandOptions& options = {});

    /// True once the script's last target's time was read. Any thread.
    [[nodiscard]] bool isFinished() const noexcept { return m_isFinished.load(std::memory_order_acquire); }
    [[nodiscard]] const HandScript& script() const noexcept { return m_script; }
    /// Where the tip really was at the last read, before its sensor rounded it [mm]. Servo thread.
    [[nodiscard]] const Vec3& tip_W() const noexcept { return m_p_W; }

    [[nodiscard]] DeviceInfo info() const override;
    /// Puts the hand back at rest at the script's beginning. Refuses options that are not finite or out of range.
    core::Status start() override;
    void stop() noexcept override;
    [[nodiscard]] DeviceState read(std::int64_t now_ns) noexcept PALPATE_NONBLOCKING override;
    void write(const Vec3& f_D) noexcept PALPATE_NONBLOCKING override;

  private:
    static constexpr std::size_t kLongestDelay = 16;
    void advance() noexcept PALPATE_NONBLOCKING;

    HandScript m_script;
    SimulatedHandOptions m_options;
    std::int64_t m_tick = 0; // of the coming read
    Vec3 m_p_W = Vec3::Zero();
    Vec3 m_v_W = Vec3::Zero();
    Vec3 m_f_W = Vec3::Zero();                   // acts until the next read
    std::array<Vec3, kLongestDelay> m_waiting{}; // forces written that do not act yet
    std::atomic<bool> m_isFinished{false};
};

} // namespace palpate::device
