// SPDX-License-Identifier: BSD-3-Clause
// Interposes the C library's clock, so that minutes of a multi-threaded program pass in seconds and in order.
#include "Time.h"

#include <algorithm>
#include <cerrno>
#include <condition_variable>
#include <cstdlib>
#include <ctime>
#include <dlfcn.h>
#include <iterator>
#include <limits>
#include <map>
#include <mutex>
#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <set>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace standin {

namespace {

struct Sleeper
{
    std::condition_variable wake;
    bool isAwake = false;
    bool isListening = false; ///< waits for a socket, and wakes early when something is sent
};

struct VirtualTime
{
    std::mutex lock;
    bool isOn = false;
    bool isPolled = false; ///< waits for sockets pass in virtual time too
    std::int64_t now_ns = 0;
    int working = 0; ///< threads that are not sleeping
    std::multimap<std::int64_t, Sleeper*> sleepers;
    std::set<pthread_t> awaited;  ///< threads that another thread waits for in pthread_join
    std::set<pthread_t> finished; ///< threads that are not joined yet
    std::set<pthread_t> detached; ///< never joined; their ids are used again

    /// Something was sent: wakes the threads that wait for a socket at `time_ns`. Requires `lock`.
    void alert(std::int64_t time_ns)
    {
        for (auto it = sleepers.upper_bound(time_ns); it != sleepers.end();) {
            const auto next = std::next(it);
            if (it->second->isListening) {
                sleepers.emplace(time_ns, it->second); // before `it`
                sleepers.erase(it);
            }
            it = next;
        }
    }

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

constexpr std::int64_t kLink_ns = 100'000;        // latency of a socket in virtual time
constexpr std::int64_t kPollEvery_ns = 2'000'000; // for events without a message, as the end of a connection
constexpr std::size_t kSignalSetSize = 8;         // of the kernel

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

namespace {

/// @param isListening  as in Sleeper
void sleepVirtually(std::int64_t time_ns, bool isListening)
{
    VirtualTime& time = virtualTime();
    {
        std::unique_lock guard(time.lock);
        if (time.isOn && t_isCounted) {
            if (time_ns <= time.now_ns) {
                return;
            }
            Sleeper sleeper;
            sleeper.isListening = isListening;
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

} // namespace

void sleepUntil(std::int64_t time_ns)
{
    sleepVirtually(time_ns, false);
}

namespace {

/// Wakes the threads that wait for a socket, after something was sent. @return `sent`
ssize_t alerted(ssize_t sent)
{
    if (sent > 0 && t_isCounted) {
        const int error = errno;
        VirtualTime& time = virtualTime();
        const std::lock_guard guard(time.lock);
        time.alert(time.now_ns + kLink_ns);
        errno = error;
    }
    return sent;
}

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

void standin_makePollsVirtual()
{
    auto& time = virtualTime();
    const std::lock_guard guard(time.lock);
    time.isPolled = true;
}

int ppoll(pollfd* fds, nfds_t count, const timespec* timeout, const sigset_t* signals)
{
    const auto ask = [&](const timespec* wait) {
        timespec changed = wait == nullptr ? timespec{} : *wait; // by the kernel
        return static_cast<int>(
            syscall(SYS_ppoll, fds, count, wait == nullptr ? nullptr : &changed, signals, standin::kSignalSetSize));
    };
    bool isVirtual = standin::t_isCounted;
    if (isVirtual) {
        auto& time = virtualTime();
        const std::lock_guard guard(time.lock);
        isVirtual = time.isOn && time.isPolled;
    }
    if (!isVirtual) {
        return ask(timeout);
    }
    const std::int64_t until_ns =
        timeout == nullptr
            ? std::numeric_limits<std::int64_t>::max()
            : standin::now_ns() + static_cast<std::int64_t>(timeout->tv_sec) * 1'000'000'000 + timeout->tv_nsec;
    for (;;) {
        const timespec none{};
        const int ready = ask(&none);
        const std::int64_t now_ns = standin::now_ns();
        if (ready != 0 || now_ns >= until_ns) {
            return ready;
        }
        standin::sleepVirtually(std::min(until_ns, now_ns + standin::kPollEvery_ns), true);
    }
}

ssize_t send(int socket, const void* bytes, std::size_t size, int flags)
{
    return standin::alerted(syscall(SYS_sendto, socket, bytes, size, flags, nullptr, 0));
}

/// Qt writes to sockets by it.
ssize_t write(int file, const void* bytes, std::size_t size)
{
    return standin::alerted(syscall(SYS_write, file, bytes, size));
}

/// For a program that the library is preloaded into.
[[gnu::constructor]] static void makeTimeVirtualIfAsked()
{
    if (std::getenv("PALPATE_STANDIN_VIRTUAL") != nullptr) {
        standin_makeTimeVirtual();
    }
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
