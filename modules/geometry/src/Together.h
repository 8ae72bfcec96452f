// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <future>

namespace palpate::geometry {

/// Items from which a second thread is worth it.
inline constexpr std::size_t kMany = 20'000;

/// Calls one() and other(): at once with two threads or more, else one after the other.
/// @throws what either throws, when both have ended
template<class One, class Other>
void together(unsigned threads, One&& one, Other&& other)
{
    std::future<void> later =
        std::async(threads > 1 ? std::launch::async : std::launch::deferred, [&other] { other(); });
    one();
    later.get();
}

/// Calls work(i) for all i from `first` up to `last`.
template<class Work>
void forEach(std::uint32_t first, std::uint32_t last, Work&& work)
{
    for (; first < last; ++first) {
        work(first);
    }
}

/// Calls work(i) for all i below `count`: with two threads or more, one half of them at once with the other.
template<class Work>
void inHalves(unsigned threads, std::uint32_t count, Work&& work)
{
    together(
        threads, [&] { forEach(0, count / 2, work); }, [&] { forEach(count / 2, count, work); });
}

} // namespace palpate::geometry
