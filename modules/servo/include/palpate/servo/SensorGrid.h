// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Realtime.h>

#include <array>

namespace palpate::servo {

/// Detects a quantized position sensor from the positions of one axis alone.
///
/// All moves of a quantized axis are multiples of one step. The same holds for a scripted path on a round grid, but
/// during steady motion the moves of a quantized axis alternate between m and m + 1 steps, and one of the two values
/// always occurs singly (0 0 1 0 0 or 1 1 0 1 1: a Sturmian word). Evidence is two such ticks, or steps that the next
/// tick reverses. Without this evidence, or with moves that are not multiples of one step, positions count as exact.
///
/// Ignores steps below 0.004 mm: at 1 kHz they change a velocity by at most 4 mm/s, 0.02 N on a damper of
/// 0.005 N·s/mm, and rounded decimals in a file look the same. Ignores steps above 0.5 mm: no device is that coarse.
/// @par Real-time Wait-free. One thread.
class PALPATE_EXPORT SensorGrid
{
  public:
    /// Processes the move since the previous tick [mm].
    void note(double move_mm) noexcept PALPATE_NONBLOCKING;
    /// @return the detected step; 0 while the sensor counts as exact [mm]
    [[nodiscard]] double step_mm() const noexcept { return m_evidence >= kEnough ? m_step_mm : 0.0; }

    /// @return true when all moves so far are multiples of this step, or without any move
    [[nodiscard]] bool fits(double step_mm) const noexcept PALPATE_NONBLOCKING;

  private:
    static constexpr int kEnough = 2;

    double m_step_mm = 0.0;           // greatest common divisor of the moves; 0: no move yet, < 0: no common step
    std::array<double, 2> m_before{}; // the last moves, newest first
    int m_evidence = 0;
};

} // namespace palpate::servo
