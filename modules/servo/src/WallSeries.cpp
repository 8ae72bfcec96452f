// SPDX-License-Identifier: BSD-3-Clause
#include "WallSeries.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace palpate::servo {

namespace {

constexpr double kAdvance_mm_per_s = 30.0;
constexpr double kImpact_mm_per_s = 300.0; // as hard as the faster approach of `palpate stability`, fitted
constexpr double kLeastFall_mm = 0.2;
constexpr double kMostFall_mm = 3.0;
constexpr double kShareOfGive = 0.4; // of the way that the hand gave: a stiff hand would leave the wall
constexpr double kPause_s = 0.4;
constexpr double kLongestPress_s = 3.0;
constexpr double kWindow_s = 0.25;   // more than a period: a soft wall swings at 6 Hz
constexpr double kSettle_s = 0.1;    // end of the advance
constexpr int kWatched = 6;          // windows; the last two decide, as in `palpate stability`: 1 s to 1.5 s
constexpr int kAlternations = 15;    // of a sensor count in a window: 30 Hz
constexpr double kSwing_mm = 0.05;   // as study::kMinSwing_mm, the limit of `palpate stability`
constexpr double kLargest_mm = 10.0; // ends the watch at once
constexpr double kStep = 1.4;
constexpr double kSoftest_N_per_mm = 0.1;
constexpr double kPrecision = 1.06;
constexpr double kLeastShare = 0.3; // of the resting force: less is a hand that gives way

} // namespace

WallSeries::WallSeries(const Setup& setup) noexcept
    : m_setup(setup)
{
    const double samples = std::round(kWindow_s / setup.dt_s);
    m_every = static_cast<std::size_t>(std::max(1.0, std::round(samples / static_cast<double>(kWindow))));
    m_size = std::min(kWindow, static_cast<std::size_t>(samples) / m_every);
    m_stiffness = std::min(setup.softest_N_per_mm, setup.stiffest_N_per_mm);
}

void WallSeries::begin(Phase phase) noexcept
{
    m_phase = phase;
    m_passed_s = 0.0;
    m_count = 0;
    m_tick = 0;
    m_windows = 0;
    m_calmWindows = 0;
    m_growing = 0;
    m_first_mm = 0.0;
    m_last_mm = 0.0;
    m_pressing_s = 0.0;
    m_away_s = 0.0;
}

/// Continues with another stiffness, at the same force.
void WallSeries::startWall(double stiffness_N_per_mm) noexcept
{
    m_wall_mm += m_force_N / stiffness_N_per_mm - m_force_N / m_stiffness;
    m_stiffness = stiffness_N_per_mm;
}

bool WallSeries::fetch(SelfTestWall& out) noexcept
{
    if (!m_hasResult) {
        return false;
    }
    out = m_result;
    m_hasResult = false;
    return true;
}

double WallSeries::limit_mm() const noexcept
{
    // A hand is never still: three times the motion at the calmest wall.
    return std::max(kSwing_mm, 3.0 * m_calm_mm);
}

/// Swing of a mass that a force of one sensor count drives at the frequency of the last window: a relay of height
/// K q excites the fundamental 4/pi K q / 2 (describing function).
double WallSeries::hiddenSwing_mm() const noexcept
{
    if (m_masses == 0 || m_changes < kAlternations) {
        return 0.0;
    }
    const double w = std::numbers::pi * m_changes / kWindow_s;
    const double mass_kg = m_massSum_kg / m_masses;
    return 1000.0 * 4.0 / std::numbers::pi * m_stiffness * m_setup.resolution_mm / (mass_kg * w * w);
}

/// A sensor that alternates between two counts hides a swing of less than a count.
bool WallSeries::isCalm(double swing_mm) const noexcept
{
    return swing_mm < limit_mm() || (swing_mm < 1.5 * m_setup.resolution_mm && hiddenSwing_mm() < limit_mm());
}

/// Estimates the mass of handle and hand from the start of the fall, in which the missing force accelerates them.
void WallSeries::noteFall(double x_mm) noexcept
{
    constexpr double kShare = 0.4;
    const double way_mm = kShare * m_fall_mm;
    if (m_isFalling && m_fallFrom_mm - x_mm >= way_mm) {
        m_isFalling = false;
        const double t_s = std::max(m_setup.dt_s, m_passed_s - m_setup.delay_s);
        m_massSum_kg += m_fallForce_N * t_s * t_s / (2.0e-3 * way_mm);
        ++m_masses;
    }
}

/// Adds a sample. @return true when a window is complete: `swing_mm` is the deviation from the line through its ends,
/// peak to peak
bool WallSeries::addToWindow(double x_mm, double& swing_mm) noexcept
{
    if (m_tick++ % m_every != 0) {
        return false;
    }
    m_window[m_count++] = x_mm;
    if (m_count < m_size) {
        return false;
    }
    m_count = 0;
    // Least squares line: a slow drift of the hand is no oscillation.
    const double middle = 0.5 * static_cast<double>(m_size - 1);
    double mean = 0.0, slope = 0.0, spread = 0.0;
    for (std::size_t i = 0; i < m_size; ++i) {
        const double t = static_cast<double>(i) - middle;
        mean += m_window[i] / static_cast<double>(m_size);
        slope += t * m_window[i];
        spread += t * t;
    }
    slope /= spread;
    double low = 0.0, high = 0.0;
    m_changes = 0;
    for (std::size_t i = 0; i < m_size; ++i) {
        const double d = m_window[i] - mean - slope * (static_cast<double>(i) - middle);
        low = std::min(low, d);
        high = std::max(high, d);
        m_changes += i > 0 && m_window[i] != m_window[i - 1] ? 1 : 0;
    }
    swing_mm = high - low;
    return true;
}

WallTick WallSeries::tick(double x_mm) noexcept PALPATE_NONBLOCKING
{
    if (!m_isPlaced) {
        m_isPlaced = true;
        m_start_mm = x_mm;
        m_wall_mm = x_mm - 2.0;
    }
    const double wallBefore_mm = m_wall_mm;
    const double forceBefore_N = m_force_N;
    m_passed_s += m_setup.dt_s;
    switch (m_phase) {
    case Phase::Pause:
        m_wall_mm = std::min(m_wall_mm, x_mm - 1.0);
        if (m_passed_s >= kPause_s) {
            m_wall_mm = x_mm - 1.0;
            ++m_part;
            begin(Phase::Press);
        }
        break;
    case Phase::Press:
    case Phase::Calm:
        press(x_mm);
        break;
    case Phase::Watch:
        watch(x_mm);
        break;
    case Phase::Done:
        break;
    }
    const bool isOut = m_phase == Phase::Pause || m_phase == Phase::Done;
    m_force_N = isOut ? 0.0 : m_stiffness * std::max(0.0, m_wall_mm - x_mm);
    WallTick out;
    out.force_N = m_force_N;
    out.work_mJ = 0.5 * (forceBefore_N + m_force_N) * (m_wall_mm - wallBefore_mm);
    return out;
}

void WallSeries::press(double x_mm) noexcept
{
    double swing_mm = 0.0;
    const bool isSettling = m_phase == Phase::Calm && m_passed_s < kSettle_s;
    const bool isWindow = !isSettling && addToWindow(x_mm, swing_mm);
    if (m_phase == Phase::Press) {
        const double missing = std::clamp((press_N() - m_force_N) / (0.2 * m_setup.press_N), 0.0, 1.0);
        const double farthest_mm = m_start_mm + m_setup.reach_mm;
        m_wall_mm = std::min(m_wall_mm + missing * kAdvance_mm_per_s * m_setup.dt_s,
                             std::max(m_wall_mm, farthest_mm + m_setup.press_N / m_stiffness));
        m_pressing_s = m_force_N > 0.9 * press_N() ? m_pressing_s + m_setup.dt_s : 0.0;
        if (x_mm > farthest_mm) {
            m_isLetGo = true;
            begin(Phase::Done);
        } else if (m_pressing_s >= 0.05 || m_passed_s >= kLongestPress_s) {
            if (m_force_N < kLeastShare * m_setup.press_N && m_passed_s >= kLongestPress_s) {
                m_isLetGo = true;
                begin(Phase::Done);
            } else {
                begin(Phase::Calm);
            }
        } else if (isWindow && swing_mm > kLargest_mm && m_pressing_s > 0.0) {
            end(false, swing_mm);
        }
        return;
    }
    if (isWindow) {
        m_calm_mm = m_part == 1 ? swing_mm : std::min(m_calm_mm, swing_mm);
        m_restForce_N = m_force_N;
        m_hand_N_per_mm = m_force_N / std::max(0.1, x_mm - m_start_mm);
        m_fall_mm = std::clamp(std::min(m_fall_mm, kShareOfGive * (x_mm - m_start_mm)), kLeastFall_mm, kMostFall_mm);
        m_wall_mm -= m_fall_mm;
        begin(Phase::Watch);
        m_fastest_mm_per_s = 0.0;
        m_recent.fill(x_mm);
        m_fallFrom_mm = x_mm;
        m_fallForce_N = std::min(m_force_N, m_stiffness * m_fall_mm);
        m_isFalling = true;
    }
}

void WallSeries::watch(double x_mm) noexcept
{
    m_away_s = m_force_N > 0.0 ? 0.0 : m_away_s + m_setup.dt_s;
    if (x_mm > m_start_mm + m_setup.reach_mm || m_away_s > 0.5) {
        m_isLetGo = true;
        begin(Phase::Done);
        return;
    }
    if (m_windows < 1) {
        noteFall(x_mm);
        m_fastest_mm_per_s = std::max(m_fastest_mm_per_s, std::abs(x_mm - m_recent.back()) /
                                                              (static_cast<double>(m_recent.size()) * m_setup.dt_s));
        std::copy_backward(m_recent.begin(), m_recent.end() - 1, m_recent.end());
        m_recent.front() = x_mm;
    }
    double swing_mm = 0.0;
    if (!addToWindow(x_mm, swing_mm)) {
        return;
    }
    ++m_windows;
    const double limit = limit_mm();
    if (m_windows <= 2) { // contains the fall itself
        m_first_mm = std::max(m_first_mm, swing_mm);
    }
    m_growing = m_windows > 2 && swing_mm > 1.1 * m_last_mm && swing_mm > 4.0 * limit ? m_growing + 1 : 0;
    m_calmWindows = isCalm(swing_mm) ? m_calmWindows + 1 : 0;
    m_last_mm = swing_mm;
    const bool isLost = swing_mm > kLargest_mm || m_growing >= 3 || (m_growing > 0 && swing_mm > 1.5 * m_first_mm);
    if (isLost || m_windows == kWatched) {
        end(!isLost && m_calmWindows >= 2, swing_mm);
    }
}

/// The hand presses with the resting force after the fall, and with more before.
double WallSeries::press_N() const noexcept
{
    return std::min(m_setup.press_N + m_hand_N_per_mm * m_fall_mm, 1.5 * m_setup.press_N);
}

/// The speed of the impact grows with the root of the fall.
void WallSeries::adaptFall() noexcept
{
    if (m_fastest_mm_per_s > 0.0) {
        const double ratio = kImpact_mm_per_s / m_fastest_mm_per_s;
        m_fall_mm = std::clamp(m_fall_mm * std::clamp(ratio * ratio, 0.5, 2.0), kLeastFall_mm, kMostFall_mm);
    }
}

void WallSeries::end(bool isHeld, double swing_mm) noexcept
{
    m_result = {};
    m_result.stiffness_N_per_mm = m_stiffness;
    m_result.press_N = m_restForce_N;
    m_result.swing_mm = swing_mm;
    m_result.settled_s = m_passed_s - m_calmWindows * kWindow_s;
    m_result.isControlled = m_setup.isControlled;
    m_result.isHeld = isHeld;
    m_hasResult = true;
    adaptFall();
    next(isHeld);
}

void WallSeries::next(bool isHeld) noexcept
{
    const double was = m_stiffness;
    (isHeld ? m_held : m_lost) = was;
    const bool isAtEnd = isHeld && was >= m_setup.stiffest_N_per_mm;
    const bool isTooSoft = m_held <= 0.0 && was <= kSoftest_N_per_mm;
    if (isAtEnd || isTooSoft || (m_held > 0.0 && m_lost > 0.0 && m_lost / m_held <= kPrecision)) {
        begin(Phase::Done);
        return;
    }
    const double stiffness = m_held <= 0.0  ? std::max(kSoftest_N_per_mm, 0.5 * was)
                             : m_lost > 0.0 ? std::sqrt(m_held * m_lost)
                                            : std::min(m_setup.stiffest_N_per_mm, was * kStep);
    if (isHeld) {
        startWall(stiffness);
        ++m_part;
        begin(Phase::Press);
    } else {
        m_stiffness = stiffness;
        begin(Phase::Pause);
    }
}

} // namespace palpate::servo
