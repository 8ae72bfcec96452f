// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Realtime.h>
#include <palpate/core/Types.h>

#include <array>
#include <cstddef>

namespace palpate::servo {

using core::Vec3;

/// How far a tip moves each tick, as far as a sensor that counts in steps can tell.
///
/// A slow tip gives rest, rest, a whole step, rest: differences of two ticks are then steps in one tick that never
/// were. Here the velocity along each axis is that over the longest past in which a straight line stays within a step
/// of every sample: many ticks while slow, one while fast or turning. A place is moved along by it and kept within half
/// a step of the sample, so that its moves add up to the tip's own and no drift gathers. With an exact sensor it is the
/// sample.
/// @par Source Janabi-Sharifi, Hayward & Chen, IEEE Trans. Control Systems Technology 8 (2000) 1003,
/// doi:10.1109/87.880606 (first-order adaptive windowing, end-fit). Differs: the place that follows.
/// @par Real-time Wait-free; at most 3 x kLongest steps. One thread.
class MotionTrack
{
  public:
    /// Longest past that is looked at, in ticks.
    static constexpr std::size_t kLongest = 32;

    /// @param resolution_mm  an axis' sample is off by at most half of it, >= 0; 0: exact [mm]
    explicit MotionTrack(double resolution_mm) noexcept
        : m_resolution_mm(resolution_mm)
    {
    }

    /// Takes the sample of a tick.
    /// @return move since the tick before; none in the first [mm]
    Vec3 step(const Vec3& p) noexcept PALPATE_NONBLOCKING;
    /// Ticks that the last move's velocity was taken over along the axis that moved most, >= 1.
    [[nodiscard]] double window() const noexcept { return m_window; }
    /// The next sample is the first.
    void reset() noexcept PALPATE_NONBLOCKING { m_count = 0; }

  private:
    double m_resolution_mm;
    std::array<Vec3, kLongest + 1> m_samples{}; // a ring
    std::size_t m_newest = 0;
    std::size_t m_count = 0; // samples there are
    double m_window = 1.0;
    Vec3 m_place = Vec3::Zero();
};

} // namespace palpate::servo
