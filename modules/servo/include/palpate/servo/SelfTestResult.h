// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/servo/SelfTest.h"

#include <palpate/core/Export.h>
#include <palpate/core/TimingHistogram.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace palpate::servo {

/// Position at rest, without a force.
struct RestMeasure
{
    double noise_mm = 0.0;      ///< deviation from straight lines over 50 ms, root mean square, along the noisiest axis
    double noisePeak_mm = 0.0;  ///< the same, largest peak to peak of such a line
    double resolution_mm = 0.0; ///< 5th percentile of the moves of an axis from one state to the next; 0: none moved
    double states_per_s = 0.0;  ///< rate of new measurements
};

/// Time from sending a force to seeing the motion.
struct RoundTripMeasure
{
    int pulses = 0;
    double median_ms = 0.0; ///< age of the position included
    double p99_ms = 0.0;
    double mass_kg = 0.0;                           ///< apparent mass at the handle; of the hand as well if it was held
    std::vector<double> each_ms;                    ///< in the order of the pulses
    std::vector<std::array<double, 2>> response_mm; ///< mean response to a pulse: time after sending [ms], way [mm]
};

/// Positions during one wall: time after its start [ms], way [mm].
struct WallTrace
{
    SelfTestWall wall;
    std::vector<std::array<double, 2>> way_mm;
};

/// Result of a self-test. A member without a value was not measured.
struct SelfTestResult : SelfTestFacts
{
    double ticks_per_s = 0.0;
    double duration_s = 0.0;
    core::TimingSummary driverLatency; ///< as reported by the driver; count 0: not reported
    std::optional<RestMeasure> rest;
    std::optional<double> friction_N; ///< mean of the ramps that moved the handle
    double frictionSpread_N = 0.0;    ///< largest deviation of a ramp from the mean
    double frictionBound_N = 0.0;     ///< force up to which the ramps went
    std::optional<RoundTripMeasure> roundTrip;
    std::optional<double> held_N_per_mm; ///< without the passivity controller; 0: not even the softest wall
    std::optional<double> heldControlled_N_per_mm;
    std::vector<WallTrace> traces; ///< stiffest held wall and softest lost wall, without and with controller
    double limit_N_per_mm = 0.0;   ///< in the window, for this device, rate and delay

    /// Every quantity was measured.
    [[nodiscard]] PALPATE_EXPORT bool isComplete() const noexcept;
    /// The test ended by a fault of the device or by the user: no page is written.
    [[nodiscard]] PALPATE_EXPORT bool isFailed() const noexcept;
};

/// Evaluates a finished test. Not on the servo thread.
[[nodiscard]] PALPATE_EXPORT SelfTestResult evaluate(const SelfTestRecord& record,
                                                     const core::TimingSummary& driverLatency = {});
/// @return one message for each quantity that was not measured, with the reason; the first names why the test ended
/// early
[[nodiscard]] PALPATE_EXPORT std::vector<core::Message> unmeasured(const SelfTestResult& result);

} // namespace palpate::servo
