// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Export.h"

#include <algorithm>
#include <cstddef>
#include <functional>

namespace palpate::core {

/// @return number of hardware threads, at least 1.
[[nodiscard]] PALPATE_EXPORT unsigned coreCount() noexcept;

/// Calls `work(i, thread)` once for each i below `count`, on the calling thread (number 0) and on as many others as
/// there is work for. Calls start in ascending order of i, but the assignment to threads varies: index results by i,
/// not by thread, if they must not depend on the number of threads. Continues with fewer threads if the system refuses
/// to create one. Not for the servo thread.
/// @param threads  maximum number of threads, including the calling thread
/// @throws one of the exceptions thrown by `work`, after all threads have ended; calls not yet started are skipped
PALPATE_EXPORT void parallelFor(std::size_t count, const std::function<void(std::size_t i, unsigned thread)>& work,
                                unsigned threads = coreCount());

/// Calls `work(i)` for each i below `count`, in blocks of `block` consecutive indices, for work too small to schedule
/// one by one. Otherwise as parallelFor.
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
