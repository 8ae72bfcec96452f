// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/servo/SelfTest.h"

#include <array>
#include <cstddef>

namespace palpate::servo {

/// Force of a wall in one tick.
struct WallTick
{
    double force_N = 0.0; ///< of the wall, >= 0
    double work_mJ = 0.0; ///< work of the moving wall since the last tick
};

/// Walls of rising stiffness that come to a resting hand, see SelfTest. Coordinates along the push direction: the wall
/// is at `m_wall_mm`, its inside at smaller values.
/// @par Real-time Wait-free, no allocation.
class WallSeries
{
  public:
    struct Setup
    {
        double dt_s = 0.001;
        double press_N = 3.0;
        double softest_N_per_mm = 0.1;
        double stiffest_N_per_mm = 25.0;
        double reach_mm = 30.0;     ///< largest way of the wall
        double resolution_mm = 0.0; ///< of the sensor; 0: unknown
        double delay_s = 0.001;     ///< of the device's force
        bool isControlled = false;
    };
    explicit WallSeries(const Setup& setup) noexcept;

    /// @param x_mm  position of the tip
    WallTick tick(double x_mm) noexcept PALPATE_NONBLOCKING;

    [[nodiscard]] bool isDone() const noexcept { return m_phase == Phase::Done; }
    /// The hand let go of the handle or gave way; the series is done.
    [[nodiscard]] bool isLetGo() const noexcept { return m_isLetGo; }
    /// Number of the current wall, from 1; 0: withdrawn.
    [[nodiscard]] std::uint16_t part() const noexcept { return m_phase == Phase::Pause ? std::uint16_t{0} : m_part; }
    /// Takes the result of a wall. @return false without a new one
    bool fetch(SelfTestWall& out) noexcept;
    /// Largest stiffness that was held; 0: none.
    [[nodiscard]] double held_N_per_mm() const noexcept { return m_held; }

  private:
    enum class Phase : std::uint8_t
    {
        Pause, ///< the wall is withdrawn
        Press, ///< advances
        Calm,  ///< stands still, before the fall
        Watch, ///< has fallen back
        Done,
    };
    static constexpr std::size_t kWindow = 250; ///< samples of a swing, at most
    void begin(Phase phase) noexcept;
    void startWall(double stiffness_N_per_mm) noexcept;
    void press(double x_mm) noexcept;
    void watch(double x_mm) noexcept;
    void end(bool isHeld, double swing_mm) noexcept;
    void next(bool isHeld) noexcept;
    [[nodiscard]] bool addToWindow(double x_mm, double& swing_mm) noexcept;
    void adaptFall() noexcept;
    [[nodiscard]] double press_N() const noexcept;
    void noteFall(double x_mm) noexcept;
    [[nodiscard]] double hiddenSwing_mm() const noexcept;
    [[nodiscard]] bool isCalm(double swing_mm) const noexcept;
    [[nodiscard]] double limit_mm() const noexcept;

    Setup m_setup;
    Phase m_phase = Phase::Pause;
    double m_passed_s = 0.0; ///< in the phase
    bool m_isPlaced = false;
    double m_start_mm = 0.0; ///< position of the tip at the start
    double m_wall_mm = 0.0;
    double m_stiffness = 0.0;
    double m_force_N = 0.0;
    double m_pressing_s = 0.0; ///< with the full force
    double m_away_s = 0.0;     ///< without contact
    std::uint16_t m_part = 0;
    bool m_isLetGo = false;
    double m_held = 0.0;
    double m_lost = 0.0; ///< smallest stiffness that was not held; 0: none
    // Swing of the tip.
    std::array<double, kWindow> m_window{};
    std::size_t m_count = 0;
    int m_changes = 0;       ///< of the sensor in the last window
    std::size_t m_every = 1; ///< ticks per sample
    std::size_t m_size = kWindow;
    std::size_t m_tick = 0;
    double m_calm_mm = 0.0;  ///< before the falls, the smallest of all walls
    double m_first_mm = 0.0; ///< largest swing directly after the fall
    double m_last_mm = 0.0;
    int m_windows = 0; ///< since the fall
    int m_calmWindows = 0;
    int m_growing = 0;
    SelfTestWall m_result;
    bool m_hasResult = false;
    double m_restForce_N = 0.0;
    // Fall of the wall, so that the hand falls onto it at kImpact_mm_per_s.
    double m_fall_mm = 1.0;
    double m_hand_N_per_mm = 0.0;     ///< stiffness of the hand, known after the first press
    double m_fastest_mm_per_s = 0.0;  ///< since the fall
    std::array<double, 4> m_recent{}; ///< newest first
    double m_fallFrom_mm = 0.0;
    double m_fallForce_N = 0.0; ///< missing after the fall
    double m_massSum_kg = 0.0;  ///< of handle and hand, estimated from each fall
    int m_masses = 0;
    bool m_isFalling = false;
};

} // namespace palpate::servo
