// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Realtime.h"

#include <cstdint>

namespace palpate::core {

/// Reads the monotonic clock. [ns since an arbitrary start]
/// @par Real-time Wait-free (vDSO).
[[nodiscard]] std::int64_t monotonicNow_ns() noexcept PALPATE_NONBLOCKING;

/// Sleeps until `deadline_ns` of the monotonic clock; returns at once when it has passed. The only sleep of the servo
/// thread: an absolute deadline, so that lateness never accumulates.
void sleepUntil_ns(std::int64_t deadline_ns) noexcept;

} // namespace palpate::core
