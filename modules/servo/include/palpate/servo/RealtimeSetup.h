// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>

#include <cstdint>
#include <string>
#include <vector>

namespace palpate::servo {

/// Result of one request to the operating system.
struct RealtimeItem
{
    core::Message name; ///< "real-time priority", "locked memory", ...
    bool isGranted = false;
    core::Message message; ///< the granted setting, or the reason for the refusal
    std::string
        remedy; ///< shell command that grants permission, with the next step; empty when granted or without remedy
};

/// What `releaseRealtime` does with the locked memory of the process.
enum class MemoryRelease : std::uint8_t
{
    Nothing, ///< nothing was locked here
    Unlock,  ///< unlock all: nothing was locked before
    Keep,    ///< keep what is locked, some of it by the program, and lock nothing further
};

/// Results of all requests for the servo thread.
struct RealtimeReport
{
    std::vector<RealtimeItem> items;
    /// The priority was granted, and the locked memory if it was requested.
    bool isRealtime = false;
    MemoryRelease release = MemoryRelease::Nothing; ///< for `releaseRealtime`
};

struct RealtimeRequest
{
    bool askPriority = true;                  ///< request SCHED_FIFO; only this and `lockMemory` need permission
    bool lockMemory = false;                  ///< lock the memory of the whole process, see `makeThreadRealtime`
    int priority = 70;                        ///< 1 to 99; lowered to the user's limit
    int cpu = -1;                             ///< CPU to pin the thread to; -1: any
    const char* threadName = "palpate-servo"; ///< at most 15 characters
};

/// Lists the CPUs available to the calling thread, from 0, within the limits of taskset, container and cpuset.
[[nodiscard]] PALPATE_EXPORT std::vector<int> allowedCpus();

/// Checks whether a thread can be pinned to a CPU.
/// @param cpu  -1: any, always ok
/// @return BadCommandLine when the CPU does not exist or is not in `allowedCpus`
[[nodiscard]] PALPATE_EXPORT core::Status checkCpu(int cpu);

/// Configures the calling thread for real-time work as far as permitted: SCHED_FIFO, memory locked on first touch, 1 ns
/// timer slack, a name, a CPU, and the default floating-point environment.
///
/// Locked memory concerns the whole process, present and future mappings (`mlockall`), and is therefore off by default:
/// the program decides. If the program has already locked its future mappings, its lock counts as granted and stays as
/// it is.
///
/// `feelTick` flushes denormals, not this function: a replay runs `feelTick` on another thread and must produce the
/// same bits, but FTZ and DAZ on the servo thread alone would change them. The floating-point environment is set
/// explicitly because a new thread inherits the creator's environment, which a library built with fast math changes on
/// load. Never fails; each item reports the outcome. Do not call within a tick (allocates, makes system calls).
[[nodiscard]] PALPATE_EXPORT RealtimeReport makeThreadRealtime(const RealtimeRequest& request);

/// Unlocks the process memory that `makeThreadRealtime` locked. A lock that the program itself set before remains;
/// one that it sets in between does not.
PALPATE_EXPORT void releaseRealtime(const RealtimeReport& report) noexcept;

} // namespace palpate::servo
