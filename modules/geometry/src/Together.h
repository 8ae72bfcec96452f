// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
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

} // namespace palpate::geometry
