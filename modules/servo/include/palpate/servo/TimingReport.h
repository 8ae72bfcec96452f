// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/TimingHistogram.h>

#include <cstdint>

namespace palpate::servo {

using core::TimingHistogram;
using core::TimingSummary;

/// How the servo loop kept time since it started.
struct TimingReport
{
    TimingSummary period;      ///< from wake to wake
    TimingSummary periodError; ///< |period - nominal|
    TimingSummary lateness;    ///< wake after the deadline it slept for
    TimingSummary latency;     ///< age of the device's state when the force was written
    TimingSummary solve;       ///< in the solver, ticks with a hand only
    std::uint64_t ticks = 0;
    std::uint64_t overruns = 0; ///< ticks that ended after their deadline
    std::uint64_t skipped = 0;  ///< periods left out after overruns
};

} // namespace palpate::servo
