// SPDX-License-Identifier: BSD-3-Clause
#include "Workers.h"

#include <atomic>
#include <exception>
#include <thread>

namespace palpate::meshio::internal {

void onTwoThreads(std::size_t count, const std::function<void(std::size_t, bool)>& work)
{
    std::atomic<std::size_t> next{0};
    const auto run = [&](bool isCaller) {
        std::exception_ptr failure;
        try {
            for (std::size_t i = next.fetch_add(1); i < count; i = next.fetch_add(1)) {
                work(i, isCaller);
            }
        } catch (...) {
            failure = std::current_exception();
            next = count; // the other one stops, too
        }
        return failure;
    };
    if (count < 2) {
        if (const std::exception_ptr failure = run(true)) {
            std::rethrow_exception(failure);
        }
        return;
    }
    std::exception_ptr second;
    std::thread other([&] { second = run(false); });
    const std::exception_ptr first = run(true);
    other.join();
    if (first || second) {
        std::rethrow_exception(first ? first : second);
    }
}

} // namespace palpate::meshio::internal
