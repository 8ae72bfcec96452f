// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/TimingHistogram.h>

#include <cstdint>

namespace palpate::servo {

using core::TimingHistogram;
using core::TimingSummary;

/// Timing statistics of the servo loop since the start.
struct TimingReport
{
    TimingSummary period;      ///< from wake to wake
    TimingSummary periodError; ///< |period - nominal|
    TimingSummary lateness;    ///< wake-up delay after the deadline
    TimingSummary latency;     ///< age of the device's state when the force was written
    TimingSummary solve;       ///< solver time, only ticks with a hand
    std::uint64_t ticks = 0;
    std::uint64_t overruns = 0; ///< ticks that ended after their deadline
    std::uint64_t skipped = 0;  ///< periods skipped after overruns
};

} // namespace palpate::servo
