// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/resource.h>

namespace palpate::evaluation {

/// Number of times the scheduler has preempted this thread. A tick during which this number rises does not measure the
/// solver; its time is recorded separately.
[[nodiscard]] inline long interruptions()
{
    rusage usage{};
    return ::getrusage(RUSAGE_THREAD, &usage) == 0 ? usage.ru_nivcsw : 0;
}

} // namespace palpate::evaluation
