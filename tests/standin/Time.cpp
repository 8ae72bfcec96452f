// SPDX-License-Identifier: BSD-3-Clause
// Interposes the C library's clock, so that minutes of a multi-threaded program pass in seconds and in order.
#include "Time.h"

#include <cerrno>
#include <condition_variable>
#include <ctime>
#include <dlfcn.h>
#include <map>
#include <mutex>
#include <pthread.h>
#include <sched.h>
#include <set>
#include <sys/syscall.h>
#include <unistd.h>

namespace standin {

namespace {

struct Sleeper
{
    std::condition_variable wake;
    bool isAwake = false;
};

struct VirtualTime
{
    std::mutex lock;
    bool isOn = false;
    std::int64_t now_ns = 0;
    int working = 0; ///< threads that are not sleeping
    std::multimap<std::int64_t, Sleeper*> sleepers;
    std::set<pthread_t> awaited;  ///< threads that another thread waits for in pthread_join
    std::set<pthread_t> finished; ///< threads that are not joined yet
    std::set<pthread_t> detached; ///< never joined; their ids are used again

    /// If no thread is working, advances to the earliest wake-up time. Requires `lock`.
    void settle()
    {
        if (working > 0 || sleepers.empty()) {
            return;
        }
        const auto first = sleepers.begin();
        now_ns = std::max(now_ns, first->first);
        first->second->isAwake = true;
        first->second->wake.notify_one();
        sleepers.erase(first);
        ++working;
    }
};

VirtualTime& virtualTime()
{
    static auto* time = new VirtualTime; // outlives every thread
    return *time;
}

std::int64_t systemNow(clockid_t clock)
{
    timespec t{};
    syscall(SYS_clock_gettime, clock, &t);
    return static_cast<std::int64_t>(t.tv_sec) * 1'000'000'000 + t.tv_nsec;
}

thread_local bool t_isCounted = false;

} // namespace

std::int64_t now_ns()
{
    VirtualTime& time = virtualTime();
    {
        const std::lock_guard guard(time.lock);
        if (time.isOn && t_isCounted) {
            return time.now_ns;
        }
    }
    return systemNow(CLOCK_MONOTONIC);
}

void sleepUntil(std::int64_t time_ns)
{
    VirtualTime& time = virtualTime();
    {
        std::unique_lock guard(time.lock);
        if (time.isOn && t_isCounted) {
            if (time_ns <= time.now_ns) {
                return;
            }
            Sleeper sleeper;
            time.sleepers.emplace(time_ns, &sleeper);
            --time.working;
            time.settle();
            sleeper.wake.wait(guard, [&sleeper] { return sleeper.isAwake; });
            return;
        }
    }
    const timespec until{time_ns / 1'000'000'000, time_ns % 1'000'000'000};
    while (syscall(SYS_clock_nanosleep, CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == -1 && errno == EINTR) {
    }
}

namespace {

struct Started
{
    void* (*run)(void*);
    void* argument;
};

void* runCounted(void* raw)
{
    const Started started = *static_cast<Started*>(raw);
    delete static_cast<Started*>(raw);
    t_isCounted = true;
    void* const result = started.run(started.argument);
    VirtualTime& time = virtualTime();
    const std::lock_guard guard(time.lock);
    if (time.awaited.erase(pthread_self()) == 0) { // otherwise the waiting thread takes this thread's place
        if (time.detached.erase(pthread_self()) == 0) {
            time.finished.insert(pthread_self());
        }
        --time.working;
        time.settle();
    }
    return result;
}

} // namespace

} // namespace standin

using standin::virtualTime;

extern "C" {

void standin_makeTimeVirtual()
{
    auto& time = virtualTime();
    const std::lock_guard guard(time.lock);
    time.isOn = true;
    time.now_ns = standin::systemNow(CLOCK_MONOTONIC);
    time.working = 1;
    // One thread works at a time. On one processor the next thread takes over without waking an idle processor, which
    // costs many times as much as the work itself. Threads started later inherit this.
    cpu_set_t here;
    CPU_ZERO(&here);
    CPU_SET(static_cast<std::size_t>(sched_getcpu()), &here);
    sched_setaffinity(0, sizeof here, &here);
    standin::t_isCounted = true;
}

int clock_gettime(clockid_t clock, timespec* out)
{
    if (clock == CLOCK_MONOTONIC && standin::t_isCounted) {
        const std::int64_t now_ns = standin::now_ns();
        *out = {now_ns / 1'000'000'000, now_ns % 1'000'000'000};
        return 0;
    }
    return static_cast<int>(syscall(SYS_clock_gettime, clock, out));
}

int clock_nanosleep(clockid_t clock, int flags, const timespec* request, timespec* rest)
{
    if (clock == CLOCK_MONOTONIC && standin::t_isCounted) {
        const std::int64_t asked_ns = static_cast<std::int64_t>(request->tv_sec) * 1'000'000'000 + request->tv_nsec;
        standin::sleepUntil((flags & TIMER_ABSTIME) != 0 ? asked_ns : standin::now_ns() + asked_ns);
        return 0;
    }
    return syscall(SYS_clock_nanosleep, clock, flags, request, rest) == -1 ? errno : 0;
}

int nanosleep(const timespec* request, timespec* rest)
{
    const int error = clock_nanosleep(standin::t_isCounted ? CLOCK_MONOTONIC : CLOCK_REALTIME, 0, request, rest);
    errno = error;
    return error == 0 ? 0 : -1;
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*), void* argument)
{
    using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
    static const auto create = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "pthread_create"));
    auto& time = virtualTime();
    if (!standin::t_isCounted) {
        return create(thread, attributes, run, argument);
    }
    auto* started = new standin::Started{run, argument};
    {
        const std::lock_guard guard(time.lock);
        ++time.working; // counted from now on, although not yet running
    }
    const int error = create(thread, attributes, standin::runCounted, started);
    if (error != 0) {
        const std::lock_guard guard(time.lock);
        --time.working;
        delete started;
    }
    return error;
}

int pthread_detach(pthread_t thread)
{
    using Detach = int (*)(pthread_t);
    static const auto detach = reinterpret_cast<Detach>(dlsym(RTLD_NEXT, "pthread_detach"));
    if (standin::t_isCounted) {
        auto& time = virtualTime();
        const std::lock_guard guard(time.lock);
        if (time.finished.erase(thread) == 0) {
            time.detached.insert(thread);
        }
    }
    return detach(thread);
}

int pthread_join(pthread_t thread, void** result)
{
    using Join = int (*)(pthread_t, void**);
    static const auto join = reinterpret_cast<Join>(dlsym(RTLD_NEXT, "pthread_join"));
    if (!standin::t_isCounted) {
        return join(thread, result);
    }
    auto& time = virtualTime();
    {
        const std::lock_guard guard(time.lock);
        if (time.finished.erase(thread) == 0) {
            time.awaited.insert(thread);
            --time.working;
            time.settle();
        }
    }
    return join(thread, result);
}

} // extern "C"
