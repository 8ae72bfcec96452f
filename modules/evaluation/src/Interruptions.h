// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/resource.h>

namespace palpate::evaluation {

/// How often another program has taken the core from this thread. A tick during which it rises is no measure of a
/// solver: what it took is counted apart.
[[nodiscard]] inline long interruptions()
{
    rusage usage{};
    return ::getrusage(RUSAGE_THREAD, &usage) == 0 ? usage.ru_nivcsw : 0;
}

} // namespace palpate::evaluation
