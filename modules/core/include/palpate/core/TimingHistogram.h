// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Realtime.h"

#include <atomic>
#include <cstdint>
#include <memory>

namespace palpate::core {

/// What a histogram says. All times in ns; a percentile is at most 0.4 % above the true one, never below; max is exact.
struct TimingSummary
{
    std::uint64_t count = 0;
    std::int64_t p50_ns = 0;
    std::int64_t p99_ns = 0;
    std::int64_t p999_ns = 0; ///< 99.9 %
    std::int64_t max_ns = 0;
};

/// Counts durations in bins of 1 ns up to 256 ns and of 1/256 of an octave above, to 4.3 s.
/// One thread adds, any thread may summarise meanwhile.
class TimingHistogram
{
  public:
    TimingHistogram();

    /// @param duration_ns  negative counts as 0, longer than the range as its end (max stays exact)
    /// @par Real-time Wait-free.
    void add(std::int64_t duration_ns) noexcept PALPATE_NONBLOCKING;
    /// Only while no other thread adds.
    void clear() noexcept;
    /// Any thread; while values are added, a summary of about now.
    [[nodiscard]] TimingSummary summary() const;

  private:
    std::unique_ptr<std::atomic<std::uint64_t>[]> m_bins;
    std::atomic<std::int64_t> m_max{0};
};

} // namespace palpate::core
