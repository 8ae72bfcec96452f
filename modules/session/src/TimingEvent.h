// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/servo/ServoLoop.h>

#include <cstdint>
#include <string>

namespace palpate::session {

/// How the servo loop kept time, as the object of a recording's "timing" event: for period, error of the period,
/// lateness, latency and solver the 50th, 99th and 99.9th percentile and the greatest [ns]; ticks, overruns and periods
/// left out since the loop started; whether it ran in real time; `late`, the periods left out since recording began.
[[nodiscard]] std::string timingJson(const servo::TimingReport& timing, bool isRealtime, std::uint64_t late);

} // namespace palpate::session
