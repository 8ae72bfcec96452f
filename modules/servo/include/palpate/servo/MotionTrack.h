// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/servo/SensorGrid.h"

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
/// of every sample: many ticks while slow, one while fast or turning. With an exact sensor it is the difference of the
/// last two samples, bit for bit.
///
/// The error of a steady velocity is at most a step over kLongestSlope ticks along each axis (steps of 0.12 mm at
/// 1 kHz: 1.9 mm/s). Under an acceleration a it lags behind by 2 sqrt(step a) at most, and never by more than half of
/// kLongestSlope ticks: samples that are off by half a step, and a line within a step of each, leave a parabola by at
/// most two steps, and such a chord of it is at most 4 sqrt(step / a) long.
///
/// For the energy that the motion takes up, a place is moved along by the velocity over at most kLongest ticks and kept
/// within half a step of the sample, so that its moves add up to the tip's own and no drift gathers.
/// @par Source Janabi-Sharifi, Hayward & Chen, IEEE Trans. Control Systems Technology 8 (2000) 1003,
/// doi:10.1109/87.880606 (first-order adaptive windowing, end-fit). Differs: the place that follows.
/// @par Real-time Wait-free; at most 3 x kLongestSlope steps. One thread.
class MotionTrack
{
  public:
    /// Longest past that is looked at for a move, in ticks.
    static constexpr std::size_t kLongest = 32;
    /// The same for the velocity, which must hold still by itself: a move is added up, a velocity is felt.
    static constexpr std::size_t kLongestSlope = 64;

    /// @param resolution_mm  an axis' sample is off by at most half of it, >= 0; 0: not known, then the sensor counts
    /// as
    ///                       exact until its samples show steps, see SensorGrid [mm]
    explicit MotionTrack(double resolution_mm) noexcept
        : m_resolution_mm(resolution_mm)
    {
    }

    /// Takes the sample of a tick.
    /// @return move since the tick before; none in the first [mm]
    Vec3 step(const Vec3& p) noexcept PALPATE_NONBLOCKING;
    /// The last move, as `step` returned it [mm]
    [[nodiscard]] const Vec3& moved() const noexcept { return m_moved; }
    /// Velocity of the last sample; zero in the first [mm per tick]
    [[nodiscard]] const Vec3& slope() const noexcept { return m_slope; }
    /// Ticks that the last move's velocity was taken over along the axis that moved most, >= 1.
    [[nodiscard]] double window() const noexcept { return m_window; }
    /// The next sample is the first. What is known of the sensor's steps stays.
    void reset() noexcept PALPATE_NONBLOCKING;

  private:
    [[nodiscard]] Vec3 resolutions(const Vec3& moved) noexcept;

    double m_resolution_mm;
    std::array<SensorGrid, 3> m_grids;               // used where the resolution is not known
    std::array<Vec3, kLongestSlope + 1> m_samples{}; // a ring
    std::size_t m_newest = 0;
    std::size_t m_count = 0; // samples there are
    double m_window = 1.0;
    Vec3 m_place = Vec3::Zero();
    Vec3 m_moved = Vec3::Zero();
    Vec3 m_slope = Vec3::Zero();
};

} // namespace palpate::servo
