// SPDX-License-Identifier: BSD-3-Clause
#include "Ending.h"

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <iterator>

namespace palpate::openhaptics::ending {

namespace {

constexpr std::array kSignals{SIGHUP, SIGINT, SIGQUIT, SIGILL,  SIGTRAP, SIGABRT,
                              SIGBUS, SIGFPE, SIGSEGV, SIGPIPE, SIGTERM, SIGXCPU};
constexpr int kLongestWait_ms = 5;

// Lock-free, so that a signal handler may use them.
std::atomic<bool> isArmed{false};
std::atomic<bool> isEndingNow{false};
std::atomic<unsigned> zeros{0};
static_assert(std::atomic<unsigned>::is_always_lock_free);
std::array<struct sigaction, kSignals.size()> previous;

void waitForZero() noexcept
{
    if (!isArmed) {
        return;
    }
    isEndingNow = true;
    const unsigned before = zeros;
    for (int i = 0; i < kLongestWait_ms && zeros - before < 2; ++i) {
        const timespec millisecond{0, 1'000'000};
        (void)nanosleep(&millisecond, nullptr);
    }
}

extern "C" void driveZeroAndEnd(int signal)
{
    waitForZero();
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        if (kSignals[i] == signal) {
            (void)sigaction(signal, &previous[i], nullptr);
        }
    }
    (void)raise(signal); // delivered when the handler returns
}

extern "C" void driveZeroAtExit()
{
    waitForZero();
}

} // namespace

void arm()
{
    if (isArmed.exchange(true)) {
        return;
    }
    isEndingNow = false;
    static const int registered = std::atexit(driveZeroAtExit);
    (void)registered;
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        (void)sigaction(kSignals[i], nullptr, &previous[i]);
        if ((previous[i].sa_flags & SA_SIGINFO) == 0 && previous[i].sa_handler == SIG_IGN) {
            continue;
        }
        struct sigaction ours
        {
        };
        ours.sa_handler = driveZeroAndEnd;
        sigemptyset(&ours.sa_mask);
        (void)sigaction(kSignals[i], &ours, nullptr);
    }
}

void disarm()
{
    if (!isArmed) {
        return;
    }
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        struct sigaction current
        {
        };
        if (sigaction(kSignals[i], nullptr, &current) == 0 && (current.sa_flags & SA_SIGINFO) == 0 &&
            current.sa_handler == driveZeroAndEnd) {
            (void)sigaction(kSignals[i], &previous[i], nullptr);
        }
    }
    isArmed = false;
}

bool isNear() noexcept
{
    return isEndingNow.load(std::memory_order_relaxed);
}

void noteZero() noexcept
{
    ++zeros;
}

} // namespace palpate::openhaptics::ending
