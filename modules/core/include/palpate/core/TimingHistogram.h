// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Export.h"
#include "palpate/core/Realtime.h"

#include <atomic>
#include <cstdint>
#include <memory>

namespace palpate::core {

/// Statistics of a histogram. All times in ns. Percentiles are at most 0.4 % above the true value, never below; the
/// maximum is exact.
struct TimingSummary
{
    std::uint64_t count = 0;
    std::int64_t p50_ns = 0;
    std::int64_t p99_ns = 0;
    std::int64_t p999_ns = 0; ///< 99.9th percentile
    std::int64_t max_ns = 0;
};

/// Histogram of durations with bins of 1 ns up to 256 ns and of 1/256 octave above, up to 4.3 s. One thread adds; any
/// thread may read a summary concurrently.
class PALPATE_EXPORT TimingHistogram
{
  public:
    TimingHistogram();

    /// @param duration_ns  clamped to the range of the histogram (the maximum stays exact)
    /// @par Real-time Wait-free.
    void add(std::int64_t duration_ns) noexcept PALPATE_NONBLOCKING;
    /// Clears the histogram. Not concurrently with `add`.
    void clear() noexcept;
    /// Summarises the histogram. Any thread; approximate while values are being added.
    [[nodiscard]] TimingSummary summary() const;

  private:
    std::unique_ptr<std::atomic<std::uint64_t>[]> m_bins;
    std::atomic<std::int64_t> m_max{0};
};

} // namespace palpate::core
