// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/servo/SelfTest.h"
#include "palpate/servo/SelfTestResult.h"

#include <cstddef>
#include <optional>
#include <span>

namespace palpate::servo {

/// Half of a pulse: this long forward, as long backward.
inline constexpr double kPulse_s = 0.016;

/// Answer of a handle to the pulses of a self-test.
enum class PulseVerdict : std::uint8_t
{
    Unclear, ///< no response, or none that stands out against the motion of the hand and the noise
    Follows,
    Reversed,
};

/// Judges the direction of the response by a sign test over the pulses. The response to one pulse is the mean deviation
/// of the position, in the first 24 ms, from the straight line of the 8 ms before. The test decides at four standard
/// deviations; the signs of the pulses are pseudo-random, so that a motion of the hand does not correlate with them.
/// @param samples  those of the step RoundTrip, with a few before
/// @par Real-time Wait-free, no allocation; 20 to 50 µs.
[[nodiscard]] PulseVerdict verdictOf(std::span<const SelfTestSample> samples, const Vec3& u_D) noexcept;

/// Fits the delay of the force to the same deviations. Not on the servo thread.
/// @param friction_N  0 if unknown, for the apparent mass
/// @return empty with fewer than five pulses with a response
[[nodiscard]] std::optional<RoundTripMeasure> roundTripOf(const SelfTestRecord& record, double friction_N);

} // namespace palpate::servo
