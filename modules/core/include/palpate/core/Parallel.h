// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace palpate::core {

/// @return how many threads can run at once on this machine, at least 1.
[[nodiscard]] unsigned coreCount() noexcept;

/// Calls `work(i, thread)` once for each i below `count`: on the calling thread, which is thread 0, and on as many more
/// as there is work for. Calls begin in ascending order of i; which thread makes which one is not fixed, so a result
/// that must not depend on the number of threads is kept by i, not by thread. A thread that the system refuses is done
/// without. Never from the servo thread.
/// @param threads  at most, the calling one included
/// @throws what a call throws, one of them if several do, when all threads have ended; what had not begun is left out
void parallelFor(std::size_t count, const std::function<void(std::size_t i, unsigned thread)>& work,
                 unsigned threads = coreCount());

/// Calls `work(i)` for each i below `count`, by blocks of `block` neighbouring ones: for work so small that a block of
/// it is worth a thread. As parallelFor in all else.
template<class Work>
void parallelForBlocks(std::size_t count, std::size_t block, Work&& work, unsigned threads = coreCount())
{
    parallelFor((count + block - 1) / block,
                [&](std::size_t b, unsigned /*thread*/) {
                    const std::size_t last = std::min(count, (b + 1) * block);
                    for (std::size_t i = b * block; i < last; ++i) {
                        work(i);
                    }
                },
                threads);
}

} // namespace palpate::core
