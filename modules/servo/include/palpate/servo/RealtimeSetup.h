// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <string>
#include <vector>

namespace palpate::servo {

/// One thing that was asked of the operating system.
struct RealtimeItem
{
    std::string name; ///< "real-time priority", "locked memory", ...
    bool isGranted = false;
    std::string message; ///< what was granted, or why not
    std::string remedy;  ///< shell command that permits it, with what to do after; empty when granted or none helps
};

/// What the servo thread got.
struct RealtimeReport
{
    std::vector<RealtimeItem> items;
    /// Both priority and locked memory were granted.
    bool isRealtime = false;
};

struct RealtimeRequest
{
    bool askPriority = true; ///< SCHED_FIFO and locked memory; the rest needs no permission and is always asked for
    int priority = 70;       ///< 1 to 99; lowered to what the user's limit allows
    int cpu = -1;            ///< run on this one; -1: on any
    const char* threadName = "palpate-servo"; ///< at most 15 characters
};

/// CPUs that the calling thread may run on, from 0: what taskset, a container or a cpuset leave of the machine's.
[[nodiscard]] std::vector<int> allowedCpus();

/// Says whether a thread may be asked to run on a CPU alone.
/// @param cpu  -1: on any, always ok
/// @return BadCommandLine: there is none, or it is not among `allowedCpus`
[[nodiscard]] core::Status checkCpu(int cpu);

/// Makes the calling thread as regular as permitted: SCHED_FIFO, memory locked as it is touched, 1 ns timer slack, a
/// name, a CPU, and the default floating-point environment.
///
/// Denormals are flushed by `feelTick` itself and not here: a replay runs it on another thread and must give the same
/// bits, which FTZ and DAZ on the servo thread alone would change. The environment is set, not trusted, because a new
/// thread inherits its creator's, and a library built for fast math changes that when it is loaded. Never fails: each
/// item says what it got. Not for the ticks themselves (allocates, system calls).
[[nodiscard]] RealtimeReport makeThreadRealtime(const RealtimeRequest& request);

/// Unlocks the process's memory when `makeThreadRealtime` locked it.
void releaseRealtime(const RealtimeReport& report) noexcept;

} // namespace palpate::servo
