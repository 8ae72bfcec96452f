// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "WallSeries.h"

#include "palpate/servo/SelfTest.h"

#include <array>

namespace palpate::servo {

/// Slow ramps of the force in both directions until the handle breaks away.
/// @par Real-time Wait-free, no allocation.
class BreakAway
{
  public:
    /// @param most_N  bound of the force; @param least_mm  way that counts as motion
    void start(double dt_s, double most_N, double least_mm) noexcept;
    /// @return force along the direction of the test [N]
    double tick(double x_mm) noexcept PALPATE_NONBLOCKING;
    [[nodiscard]] bool isDone() const noexcept { return m_count == m_ramps.size(); }
    [[nodiscard]] std::uint16_t part() const noexcept;
    [[nodiscard]] const std::array<SelfTestRamp, 4>& ramps() const noexcept { return m_ramps; }
    /// Mean of the ramps that moved the handle, so that a constant load cancels; the bound if none did [N]
    [[nodiscard]] double friction_N() const noexcept;

  private:
    std::array<SelfTestRamp, 4> m_ramps{};
    std::size_t m_count = 0;
    double m_dt_s = 0.001;
    double m_most_N = 0.0;
    double m_least_mm = 0.0;
    double m_passed_s = 0.0;
    double m_from_mm = 0.0;
    bool m_isPausing = true;
};

/// Pulses of the force: forward, backward, pause. Directions and pauses follow a fixed pseudo-random sequence: pulses
/// at a constant pace drive a held hand at its resonance. The directions nearly balance, so that a free handle stays.
/// @par Real-time Wait-free, no allocation.
class Pulses
{
  public:
    void start(double dt_s, double force_N, int count) noexcept;
    /// @return force along the direction of the test [N]
    double tick() noexcept PALPATE_NONBLOCKING;
    [[nodiscard]] bool isDone() const noexcept { return m_index > m_count; }
    /// Number of the current pulse and its pause, from 1; 0 in the pause before the first.
    [[nodiscard]] std::uint16_t part() const noexcept
    {
        return isDone() ? std::uint16_t{0} : static_cast<std::uint16_t>(m_index);
    }

  private:
    double m_dt_s = 0.001;
    double m_force_N = 0.0; ///< signed
    int m_count = 0;
    int m_index = 0;
    double m_passed_s = 0.0;
    double m_length_s = 0.1;        ///< of pulse and pause
    std::uint32_t m_random = 19017; ///< signs with little correlation, and at most 5 more of one than of the other
};

/// Looks for a hand: a held handle gives way and stops, a free one moves on.
/// @par Real-time Wait-free, no allocation.
class HandProbe
{
  public:
    void start(double dt_s, double force_N, double timeout_s) noexcept;
    double tick(double x_mm) noexcept PALPATE_NONBLOCKING;
    [[nodiscard]] bool isFound() const noexcept { return m_isFound; }
    [[nodiscard]] bool isOutOfTime() const noexcept { return m_total_s > m_timeout_s; }

  private:
    double m_dt_s = 0.001;
    double m_force_N = 0.0;
    double m_timeout_s = 0.0;
    double m_total_s = 0.0;
    double m_passed_s = 0.0;
    double m_from_mm = 0.0;
    double m_sign = 1.0;
    bool m_isGone = false;
    bool m_isFound = false;
};

/// State of a self-test.
class SelfTestSteps
{
  public:
    SelfTestSteps(const device::DeviceInfo& info, const SelfTestOptions& options);
    Vec3 tick(const device::DeviceState& state, std::int64_t now_ns) noexcept PALPATE_NONBLOCKING;
    void stop(SelfTestStop why) noexcept PALPATE_NONBLOCKING;
    [[nodiscard]] bool isFinished() const noexcept { return m_isEnding && m_gate.isAtRest(); }

    void noteOverrun(bool isOverrun) noexcept PALPATE_NONBLOCKING;
    void setDelay(int ticks) noexcept PALPATE_NONBLOCKING;
    [[nodiscard]] const SelfTestRecord& record() const noexcept { return m_record; }
    [[nodiscard]] double progress() const noexcept;

  private:
    void go(SelfTestStep next) noexcept;
    void goToWalls(bool isControlled, double softest_N_per_mm) noexcept;
    void wait(const device::DeviceState& state) noexcept;
    double force_N(double x_mm) noexcept;
    double wallForce_N(double x_mm) noexcept;
    double frictionForce_N(double x_mm) noexcept;
    double pulseForce_N() noexcept;
    double probeForce_N(double x_mm) noexcept;
    void rest(double x_mm) noexcept;

    SelfTestOptions m_options;
    SelfTestRecord m_record;
    SafetyGate m_gate;
    PassivityLimits m_limits;
    PassivityController m_passivity;
    BreakAway m_breakAway;
    Pulses m_pulses;
    HandProbe m_probe;
    WallSeries m_series{WallSeries::Setup{}};
    double m_dt_s;
    double m_small_N; ///< of ramps and pulses, above the friction
    double m_elapsed_s = 0.0;
    double m_inStep_s = 0.0;
    double m_inside_s = 0.0;
    bool m_isEnding = false;
    double m_low_mm = 0.0, m_high_mm = 0.0; ///< at rest
    double m_noise_mm = 0.0;
    double m_friction_N = 0.0;
    std::uint16_t m_part = 0;
    std::int64_t m_start_ns = 0;
    std::size_t m_pulsesFrom = 0; ///< first sample of the step
};

} // namespace palpate::servo
