// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/servo/ServoLoop.h>

#include <cstdint>
#include <string>

namespace palpate::session {

/// Serializes the servo timing for the "timing" event of a recording: 50th, 99th and 99.9th percentile and maximum of
/// period, period error, lateness, latency and solver time [ns]; ticks, overruns and skipped periods since the loop
/// started; real-time mode; and `late`, the periods skipped since the recording started.
[[nodiscard]] std::string timingJson(const servo::TimingReport& timing, bool isRealtime, std::uint64_t late);

} // namespace palpate::session
