// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/servo/RealtimeSetup.h"

#include <algorithm>
#include <cerrno>
#include <cfenv>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>
#include <utility>

namespace palpate::servo {

namespace {

core::Message realtimePriority()
{
    return core::Message(PALPATE_TEXT("real-time priority"));
}

core::Message lockedMemory()
{
    return core::Message(PALPATE_TEXT("locked memory"));
}

/// Command that raises both limits, effective from the next login.
constexpr const char* kRaiseLimits = "printf '%s - rtprio 80\\n%s - memlock unlimited\\n' \"$USER\" \"$USER\" | "
                                     "sudo tee /etc/security/limits.d/70-palpate.conf   # then log out and in again";

RealtimeItem priorityItem(int wanted)
{
    RealtimeItem item{realtimePriority(), false, {}, ""};
    const int lowest = sched_get_priority_min(SCHED_FIFO);
    int priority = std::clamp(wanted, lowest, sched_get_priority_max(SCHED_FIFO));
    sched_param parameter{};
    parameter.sched_priority = priority;
    int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter);
    rlimit limit{};
    if (error == EPERM && getrlimit(RLIMIT_RTPRIO, &limit) == 0 && limit.rlim_cur >= static_cast<rlim_t>(lowest) &&
        limit.rlim_cur < static_cast<rlim_t>(priority)) {
        priority = static_cast<int>(limit.rlim_cur);
        parameter.sched_priority = priority;
        error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter);
    }
    if (error == 0) {
        item.isGranted = true;
        item.message = core::Message(PALPATE_TEXT("SCHED_FIFO %1"), priority);
    } else {
        item.message = core::Message(PALPATE_TEXT("SCHED_FIFO %1 was refused: %2"), priority, core::systemError(error));
        item.remedy = kRaiseLimits;
    }
    return item;
}

/// Memory of the process that is locked [KiB], 0 if unknown.
long lockedMemory_KiB()
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("VmLck:")) {
            return std::strtol(line.c_str() + 6, nullptr, 10);
        }
    }
    return 0;
}

/// Maps a page to see whether the process locks its future mappings.
bool locksFutureMappings()
{
    const auto size = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    const long before_KiB = lockedMemory_KiB();
    void* page = mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (page == MAP_FAILED) {
        return false;
    }
    const bool isLocked = lockedMemory_KiB() > before_KiB;
    munmap(page, size);
    return isLocked;
}

void release(MemoryRelease how) noexcept
{
    if (how == MemoryRelease::Unlock) {
        munlockall();
    } else if (how == MemoryRelease::Keep) {
        mlockall(MCL_CURRENT | MCL_ONFAULT); // without MCL_FUTURE, which it ends
    }
}

/// @param how  set to what releases the lock
RealtimeItem memoryItem(MemoryRelease& how)
{
    RealtimeItem item{lockedMemory(), false, {}, ""};
    const bool hasLocked = lockedMemory_KiB() > 0;
    if (hasLocked && locksFutureMappings()) {
        item.isGranted = true;
        item.message = core::Message(PALPATE_TEXT("the program has locked its memory itself"));
        return item;
    }
    // Pages are locked as they are touched: locking all that is mapped would fill memory with untouched stacks.
    if (mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) != 0) {
        item.message = core::Message(PALPATE_TEXT("mlockall was refused: %1"), core::systemError(errno));
        item.remedy = kRaiseLimits;
        return item;
    }
    how = hasLocked ? MemoryRelease::Keep : MemoryRelease::Unlock;
    // Under a finite limit, MCL_FUTURE would make later allocations of the whole program fail. A privileged process may
    // exceed the limit; mapping more than the limit shows whether this one may.
    rlimit limit{};
    if (getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
        const std::size_t size = static_cast<std::size_t>(limit.rlim_cur) + (std::size_t{1} << 20U);
        void* probe = mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        const int error = errno;
        if (probe == MAP_FAILED) {
            release(std::exchange(how, MemoryRelease::Nothing));
            item.message = core::Message(PALPATE_TEXT("only %1 KiB may be locked: %2"), limit.rlim_cur / 1024,
                                         core::systemError(error));
            item.remedy = kRaiseLimits;
            return item;
        }
        munmap(probe, size);
    }
    item.isGranted = true;
    item.message = core::Message(PALPATE_TEXT("pages stay in memory once touched"));
    return item;
}

/// Touches the stack that the ticks will use, so that no tick causes a page fault there. Not inlined, so that the frame
/// is released on return.
__attribute__((noinline)) void touchStack() noexcept
{
    constexpr std::size_t kStack = 256 * 1024;
    volatile char stack[kStack];
    for (std::size_t i = 0; i < kStack; i += 1024) {
        stack[i] = 0;
    }
    static_cast<void>(stack[0]);
}

/// Formats CPU numbers as in taskset: 0-3,8.
std::string cpuList(const std::vector<int>& cpus)
{
    std::string out;
    for (std::size_t i = 0; i < cpus.size();) {
        std::size_t last = i;
        while (last + 1 < cpus.size() && cpus[last + 1] == cpus[last] + 1) {
            ++last;
        }
        out += out.empty() ? "" : ",";
        out += std::to_string(cpus[i]);
        if (last > i) {
            out += "-";
            out += std::to_string(cpus[last]);
        }
        i = last + 1;
    }
    return out;
}

} // namespace

std::vector<int> allowedCpus()
{
    cpu_set_t set;
    CPU_ZERO(&set);
    std::vector<int> cpus;
    if (sched_getaffinity(0, sizeof(set), &set) == 0) {
        for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
            if (CPU_ISSET(static_cast<unsigned>(cpu), &set)) {
                cpus.push_back(cpu);
            }
        }
    }
    return cpus;
}

core::Status checkCpu(int cpu)
{
    const std::vector<int> allowed = allowedCpus();
    if (cpu == -1 || std::find(allowed.begin(), allowed.end(), cpu) != allowed.end()) {
        return {};
    }
    const bool isThere = cpu >= 0 && cpu < sysconf(_SC_NPROCESSORS_CONF);
    return {core::StatusCode::BadCommandLine,
            isThere ? core::Message(PALPATE_TEXT("CPU %1: the program may not run on it (see taskset -p, or the "
                                                 "container's settings), expected one of %2"),
                                    cpu, cpuList(allowed))
                    : core::Message(PALPATE_TEXT("CPU %1: this machine has no such CPU, expected one of %2"), cpu,
                                    cpuList(allowed))};
}

RealtimeReport makeThreadRealtime(const RealtimeRequest& request)
{
    RealtimeReport report;

    char name[16] = {};
    std::strncpy(name, request.threadName, sizeof(name) - 1);
    const int named = pthread_setname_np(pthread_self(), name);
    report.items.push_back({core::Message(PALPATE_TEXT("thread name")), named == 0,
                            named == 0 ? core::Message(PALPATE_TEXT("\"%1\""), name) : core::systemError(named), ""});

    const core::Message notAsked(PALPATE_TEXT("not asked for"));
    report.items.push_back(request.askPriority ? priorityItem(request.priority)
                                               : RealtimeItem{realtimePriority(), false, notAsked, ""});
    report.isRealtime = report.items.back().isGranted;
    report.items.push_back(request.lockMemory ? memoryItem(report.release)
                                              : RealtimeItem{lockedMemory(), false, notAsked, ""});
    report.isRealtime = report.isRealtime && (report.items.back().isGranted || !request.lockMemory);
    if (request.askPriority || request.lockMemory) {
        touchStack();
    }

    const bool hasSlack = prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL) == 0;
    report.items.push_back({core::Message(PALPATE_TEXT("timer slack")), hasSlack,
                            hasSlack ? core::Message(PALPATE_TEXT("%1 ns"), 1) : core::systemError(errno), ""});

    if (request.cpu >= 0) {
        cpu_set_t set;
        CPU_ZERO(&set);
        int error = EINVAL;
        if (request.cpu < CPU_SETSIZE) {
            CPU_SET(static_cast<unsigned>(request.cpu), &set);
            error = pthread_setaffinity_np(pthread_self(), sizeof(set), &set);
        }
        report.items.push_back(
            {core::Message(PALPATE_TEXT("own CPU")), error == 0,
             error == 0 ? core::Message(PALPATE_TEXT("CPU %1"), request.cpu)
                        : core::Message(PALPATE_TEXT("CPU %1 was refused: %2"), request.cpu, core::systemError(error)),
             ""});
    }

    const bool isDefault = std::fesetenv(FE_DFL_ENV) == 0;
    report.items.push_back(
        {core::Message(PALPATE_TEXT("floating point")), isDefault,
         isDefault ? core::Message(PALPATE_TEXT("default environment, denormals kept: a replay gives the same bits"))
                   : core::Message(PALPATE_TEXT("the default environment could not be set")),
         ""});
    return report;
}

void releaseRealtime(const RealtimeReport& report) noexcept
{
    release(report.release);
}

} // namespace palpate::servo
