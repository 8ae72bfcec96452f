// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/servo/SensorGrid.h"

#include <palpate/core/Export.h>
#include <palpate/core/Realtime.h>
#include <palpate/core/Types.h>

#include <array>
#include <cstddef>

namespace palpate::servo {

using core::Vec3;

/// Estimates the motion of the HIP per tick from a sensor of finite resolution.
///
/// A slow motion on a quantized sensor yields rest, rest, a whole step, rest. Differences of two consecutive samples
/// then show velocity spikes. This class takes the velocity of each axis over the longest window in which a straight
/// line stays within one step of every sample: many ticks for slow motion, one tick for fast motion or a change of
/// direction. With an exact sensor the result equals the difference of the last two samples, bit for bit.
///
/// The error of a steady velocity is at most one step over kLongestSlope ticks along each axis (steps of 0.12 mm at
/// 1 kHz: 1.9 mm/s). Under an acceleration a the lag is at most 2 sqrt(step a) and never exceeds half of
/// kLongestSlope ticks: with samples that are off by half a step and a line within one step of each, the deviation
/// from a parabola is at most two steps, and such a chord is at most 4 sqrt(step / a) long.
///
/// For the energy balance, a tracked position advances by the velocity over at most kLongest ticks and is clamped to
/// half a step around the sample. The sum of its moves therefore follows the HIP without drift.
/// @par Source Janabi-Sharifi, Hayward & Chen, IEEE Trans. Control Systems Technology 8 (2000) 1003,
/// doi:10.1109/87.880606 (first-order adaptive windowing, end-fit). Differs: the tracked position.
/// @par Real-time Wait-free; at most 3 x kLongestSlope steps. One thread.
class PALPATE_EXPORT MotionTrack
{
  public:
    /// Longest window for a move, in ticks.
    static constexpr std::size_t kLongest = 32;
    /// Longest window for the velocity, in ticks. Longer than kLongest because errors of consecutive moves cancel in
    /// their sum, whereas each error of the velocity becomes a force of the tissue dampers at once.
    static constexpr std::size_t kLongestSlope = 64;

    /// @param resolution_mm  step size of the sensor, >= 0; a sample is off by at most half a step. 0: unknown; the
    /// sensor then counts as exact until the samples show steps (see SensorGrid) [mm]
    explicit MotionTrack(double resolution_mm) noexcept
        : m_resolution_mm(resolution_mm)
    {
    }

    /// Processes the sample of a tick.
    /// @return move since the previous tick; zero for the first sample [mm]
    Vec3 step(const Vec3& p) noexcept PALPATE_NONBLOCKING;
    /// Last return value of `step` [mm]
    [[nodiscard]] const Vec3& moved() const noexcept { return m_moved; }
    /// Velocity at the last sample; zero for the first sample [mm per tick]
    [[nodiscard]] const Vec3& slope() const noexcept { return m_slope; }
    /// Window of the last move along the axis with the largest move, 1 to kLongest [ticks]
    [[nodiscard]] double window() const noexcept { return m_window; }
    /// Discards all samples but keeps the detected sensor steps.
    void reset() noexcept PALPATE_NONBLOCKING;

  private:
    [[nodiscard]] Vec3 resolutions(const Vec3& moved) noexcept;

    double m_resolution_mm;
    std::array<SensorGrid, 3> m_grids;               // used if the resolution is unknown
    std::array<Vec3, kLongestSlope + 1> m_samples{}; // ring buffer
    std::size_t m_newest = 0;
    std::size_t m_count = 0; // number of earlier samples available, at most kLongestSlope
    double m_window = 1.0;
    Vec3 m_place = Vec3::Zero();
    Vec3 m_moved = Vec3::Zero();
    Vec3 m_slope = Vec3::Zero();
};

} // namespace palpate::servo
