// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace standin {

/// Monotonic time of this process: the system's, or a virtual one.
std::int64_t now_ns();
/// Sleeps until then, in the same time.
void sleepUntil(std::int64_t time_ns);

} // namespace standin

/// Makes time virtual from now on: it stands still while any thread works and jumps to the earliest sleeper's hour when
/// all sleep. Counts the calling thread and every thread that is created afterwards; each of them may wait for another
/// only by sleeping (clock_nanosleep, nanosleep, hidapi) or by pthread_join.
extern "C" void standin_makeTimeVirtual();
