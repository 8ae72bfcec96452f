// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Realtime.h>

#include <array>

namespace palpate::servo {

/// Recognises a position sensor that counts in steps from the positions of one axis alone.
///
/// All moves of such an axis are multiples of one step. That holds for a scripted path on a round grid as well; but
/// while a counted axis moves steadily its moves alternate between m and m + 1 steps, and one of the two always comes
/// alone (0 0 1 0 0 or 1 1 0 1 1: a Sturmian word). Two such ticks, or steps that the next tick takes back, are taken
/// as evidence. Until then, and where moves are no multiples of one step, the positions count as exact.
///
/// Steps below 0.004 mm are ignored: at 1 kHz they change a velocity by at most 4 mm/s, 0.02 N on a damper of
/// 0.005 N·s/mm, and decimals in a file look like them. So are steps above 0.5 mm: no device is as coarse.
/// @par Real-time Wait-free. One thread.
class SensorGrid
{
  public:
    /// Takes the move since the tick before. [mm]
    void note(double move_mm) noexcept PALPATE_NONBLOCKING;
    /// @return the step; 0 as long as the sensor counts as exact [mm]
    [[nodiscard]] double step_mm() const noexcept { return m_evidence >= kEnough ? m_step_mm : 0.0; }

    /// @return true when nothing is known against this step: all moves so far were multiples of it, or there were none
    [[nodiscard]] bool fits(double step_mm) const noexcept PALPATE_NONBLOCKING;

  private:
    static constexpr int kEnough = 2;

    double m_step_mm = 0.0;           // greatest common divisor of the moves so far; 0: none yet, < 0: there is none
    std::array<double, 2> m_before{}; // the last moves, newest first
    int m_evidence = 0;
};

} // namespace palpate::servo
