// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Realtime.h"

#include <cstdint>
#include <limits>

namespace palpate::core {

/// Reads the monotonic clock. [ns since an arbitrary start]
/// @par Real-time Wait-free (vDSO).
[[nodiscard]] std::int64_t monotonicNow_ns() noexcept PALPATE_NONBLOCKING;

/// A duration as a tick's record holds it: 0 when it is negative, 2^32 - 1 when it is longer than that. [ns]
[[nodiscard]] constexpr std::uint32_t shortDuration_ns(std::int64_t duration_ns) noexcept
{
    constexpr std::int64_t kMost_ns = std::numeric_limits<std::uint32_t>::max();
    return static_cast<std::uint32_t>(duration_ns < 0 ? 0 : duration_ns > kMost_ns ? kMost_ns : duration_ns);
}

/// Sleeps until `deadline_ns` of the monotonic clock; returns at once when it has passed. The only sleep of the servo
/// thread: an absolute deadline, so that lateness never accumulates.
void sleepUntil_ns(std::int64_t deadline_ns) noexcept;

} // namespace palpate::core
