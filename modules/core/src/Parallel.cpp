// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/core/Parallel.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace palpate::core {

unsigned coreCount() noexcept
{
    return std::max(1U, std::thread::hardware_concurrency()); // 0 if unknown
}

void parallelFor(std::size_t count, const std::function<void(std::size_t, unsigned)>& work, unsigned threads)
{
    std::atomic<std::size_t> next{0};
    std::mutex mutex;
    std::exception_ptr failure;
    const auto run = [&](unsigned thread) {
        try {
            for (std::size_t i = next++; i < count; i = next++) {
                work(i, thread);
            }
        } catch (...) {
            const std::scoped_lock lock(mutex);
            failure = std::current_exception();
            next = count; // stops the other threads
        }
    };
    std::vector<std::thread> others;
    const auto useful = static_cast<unsigned>(std::min<std::size_t>(threads, count));
    others.reserve(useful);
    try {
        for (unsigned thread = 1; thread < useful; ++thread) {
            others.emplace_back(run, thread);
        }
    } catch (const std::exception&) { // continue with the threads created so far
    }
    run(0);
    for (std::thread& other : others) {
        other.join();
    }
    if (failure) {
        std::rethrow_exception(failure);
    }
}

} // namespace palpate::core
