// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace standin {

/// Returns the monotonic time of this process: the system's, or virtual.
std::int64_t now_ns();
/// Sleeps until then, in the same time.
void sleepUntil(std::int64_t time_ns);

} // namespace standin

/// Makes time virtual from now on: stands still while any thread works, and jumps to the earliest wake-up time when all
/// threads sleep. Counts the calling thread and every thread created afterwards; a counted thread may wait for another
/// only by sleeping (clock_nanosleep, nanosleep, hidapi) or by pthread_join.
extern "C" void standin_makeTimeVirtual();
/// Also lets waits for sockets (ppoll) pass in virtual time, for two counted threads that talk to each other over the
/// loopback interface. A message takes 0.1 ms.
extern "C" void standin_makePollsVirtual();
