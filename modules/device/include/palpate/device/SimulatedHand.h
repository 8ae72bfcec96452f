// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/device/DevicePresets.h"
#include "palpate/device/HandScript.h"
#include "palpate/device/HapticDevice.h"

#include <palpate/core/Export.h>

#include <array>
#include <atomic>
#include <cstddef>

namespace palpate::device {

/// Parameters of a simulated hand holding a simulated device. The defaults model a light, well damped grip (0.7 of
/// critical damping at 11 Hz); they are plausible values, not measurements.
struct SimulatedHandOptions
{
    DevicePreset preset = *findDevicePreset("touch"); ///< limits of the simulated device
    double rate_Hz = 1000.0;                          ///< servo rate; each tick advances the hand by 1 / rate_Hz
    double mass_kg = 0.1;                             ///< effective mass of fingers and device at the tip
    double gripStiffness_N_per_mm = 0.5;              ///< spring between tip and target
    double gripDamping_Ns_per_mm = 0.01;              ///< damper between the velocities of tip and target
    double deviceDamping_Ns_per_mm = 0.0005;          ///< viscous friction of the device, as a damper to the ground
    double friction_N = 0.0;                          ///< Coulomb friction of the device
    double resolution_mm = 0.0;                       ///< encoder step of the position readings; 0: exact
    int delayTicks = 0;                               ///< delay of a written force, 0 to 16 ticks
    int subSteps = 20;                                ///< integration steps per tick, >= 1
    bool isRigid = false;                             ///< follows the script exactly, unaffected by forces
};

/// Simulated hand that follows a script and responds to forces ("simulated-hand"): a mass coupled to the script's
/// target by a spring and damper, and driven by the last written force:
///   m a = k (p_target - p) + b (v_target - v) - b_device v + f - friction,
/// integrated with semi-implicit Euler. Coulomb friction removes at most the current speed, so that the tip can stick.
/// Each `read` advances the simulation by one servo period, independent of the clock: identical scripts and forces give
/// bit-identical motion. D is the world frame. The device moves along with the script, so the workspace is unlimited.
class PALPATE_EXPORT SimulatedHand final : public HapticDevice
{
  public:
    explicit SimulatedHand(HandScript script, const SimulatedHandOptions& options = {});

    /// True after the time of the script's last target was read. Any thread.
    [[nodiscard]] bool isFinished() const noexcept { return m_isFinished.load(std::memory_order_acquire); }
    [[nodiscard]] const HandScript& script() const noexcept { return m_script; }
    /// Exact tip position at the last read, before sensor quantisation [mm]. Servo thread.
    [[nodiscard]] const Vec3& tip_W() const noexcept { return m_p_W; }

    [[nodiscard]] DeviceInfo info() const override;
    /// Resets the hand to rest at the start of the script. Fails for non-finite or out-of-range options.
    core::Status start() override;
    void stop() noexcept override;
    [[nodiscard]] DeviceState read(std::int64_t now_ns) noexcept PALPATE_NONBLOCKING override;
    void write(const Vec3& f_D) noexcept PALPATE_NONBLOCKING override;

  private:
    static constexpr std::size_t kMaxDelayTicks = 16;
    void advance() noexcept PALPATE_NONBLOCKING;

    HandScript m_script;
    SimulatedHandOptions m_options;
    std::int64_t m_tick = 0; // tick of the next read
    Vec3 m_p_W = Vec3::Zero();
    Vec3 m_v_W = Vec3::Zero();
    Vec3 m_f_W = Vec3::Zero();                    // force acting until the next read
    std::array<Vec3, kMaxDelayTicks> m_waiting{}; // written forces still delayed
    std::atomic<bool> m_isFinished{false};
};

} // namespace palpate::device
