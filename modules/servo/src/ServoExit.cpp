// SPDX-License-Identifier: BSD-3-Clause
#include "ServoExit.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <vector>

namespace palpate::servo {

namespace {

struct Loop
{
    std::atomic<bool>* isStopRequested;
    const std::atomic<bool>* isRunning;
};

std::mutex& mutex()
{
    static auto* const made = new std::mutex; // never destroyed, because it is used during program exit
    return *made;
}

std::vector<Loop>& loops()
{
    static auto* const made = new std::vector<Loop>;
    return *made;
}

void stopAll()
{
    using namespace std::chrono_literals;
    const std::lock_guard lock(mutex());
    for (const Loop& loop : loops()) {
        loop.isStopRequested->store(true, std::memory_order_release);
    }
    const auto isAnyRunning = [] {
        return std::any_of(loops().begin(), loops().end(),
                           [](const Loop& loop) { return loop.isRunning->load(std::memory_order_acquire); });
    };
    if (!isAnyRunning()) {
        return;
    }
    for (int i = 0; i < 100 && isAnyRunning(); ++i) {
        std::this_thread::sleep_for(1ms);
    }
    std::this_thread::sleep_for(5ms); // time for the driver's own thread to send the zero force
}

} // namespace

void stopAtExit(std::atomic<bool>& isStopRequested, const std::atomic<bool>& isRunning)
{
    static const bool isRegistered = std::atexit(stopAll) == 0;
    static_cast<void>(isRegistered);
    const std::lock_guard lock(mutex());
    if (std::none_of(loops().begin(), loops().end(),
                     [&](const Loop& loop) { return loop.isStopRequested == &isStopRequested; })) {
        loops().push_back({&isStopRequested, &isRunning});
    }
}

void forgetAtExit(const std::atomic<bool>& isStopRequested) noexcept
{
    const std::lock_guard lock(mutex());
    std::erase_if(loops(), [&](const Loop& loop) { return loop.isStopRequested == &isStopRequested; });
}

} // namespace palpate::servo
