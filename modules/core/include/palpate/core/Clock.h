// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Export.h"
#include "palpate/core/Realtime.h"

#include <cstdint>
#include <limits>

namespace palpate::core {

/// Reads the monotonic clock. [ns since an arbitrary start]
/// @par Real-time Wait-free (vDSO).
[[nodiscard]] PALPATE_EXPORT std::int64_t monotonicNow_ns() noexcept PALPATE_NONBLOCKING;

/// Duration saturated to the 32 bits of a tick record: 0 if negative, 2^32 - 1 if longer. [ns]
[[nodiscard]] constexpr std::uint32_t shortDuration_ns(std::int64_t duration_ns) noexcept
{
    constexpr std::int64_t kMost_ns = std::numeric_limits<std::uint32_t>::max();
    return static_cast<std::uint32_t>(duration_ns < 0 ? 0 : duration_ns > kMost_ns ? kMost_ns : duration_ns);
}

/// Sleeps until `deadline_ns` on the monotonic clock; returns immediately if the deadline has passed. The servo thread
/// sleeps only here, on absolute deadlines, so that lateness does not accumulate.
PALPATE_EXPORT void sleepUntil_ns(std::int64_t deadline_ns) noexcept;

} // namespace palpate::core
