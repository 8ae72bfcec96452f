// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/core/TimingHistogram.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <vector>

namespace palpate::core {

namespace {

constexpr int kBits = 8; // 2^8 bins per octave
constexpr std::uint64_t kPerOctave = 1U << kBits;
constexpr std::uint64_t kLargest = 0xFFFFFFFF; // 4.3 s
constexpr std::size_t kBins = kPerOctave * (32 - kBits + 1);

std::size_t binOf(std::uint64_t value) noexcept
{
    if (value < kPerOctave) {
        return value;
    }
    const int shift = static_cast<int>(std::bit_width(value)) - kBits - 1;
    return kPerOctave * static_cast<std::size_t>(shift) + (value >> shift);
}

/// Upper limit of a bin.
std::uint64_t topOf(std::size_t bin) noexcept
{
    if (bin < 2 * kPerOctave) {
        return bin;
    }
    const std::size_t shift = bin / kPerOctave - 1;
    const std::uint64_t mantissa = bin - shift * kPerOctave;
    return ((mantissa + 1) << shift) - 1;
}

} // namespace

TimingHistogram::TimingHistogram()
    : m_bins(std::make_unique<std::atomic<std::uint64_t>[]>(kBins))
{
    static_assert(std::atomic<std::uint64_t>::is_always_lock_free);
}

void TimingHistogram::add(std::int64_t duration_ns) noexcept PALPATE_NONBLOCKING
{
    const std::int64_t duration = std::max<std::int64_t>(duration_ns, 0);
    std::atomic<std::uint64_t>& bin = m_bins[binOf(std::min(static_cast<std::uint64_t>(duration), kLargest))];
    // Single writer: separate load and store suffice, without a read-modify-write.
    bin.store(bin.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    if (duration > m_max.load(std::memory_order_relaxed)) {
        m_max.store(duration, std::memory_order_relaxed);
    }
}

void TimingHistogram::clear() noexcept
{
    for (std::size_t i = 0; i < kBins; ++i) {
        m_bins[i].store(0, std::memory_order_relaxed);
    }
    m_max.store(0, std::memory_order_relaxed);
}

TimingSummary TimingHistogram::summary() const
{
    std::vector<std::uint64_t> counts(kBins);
    TimingSummary out;
    for (std::size_t i = 0; i < kBins; ++i) {
        counts[i] = m_bins[i].load(std::memory_order_relaxed);
        out.count += counts[i];
    }
    out.max_ns = m_max.load(std::memory_order_relaxed);
    if (out.count == 0) {
        return out;
    }
    // Rank of a per mille quantile: number of values at or below the quantile, rounded up.
    const auto rank = [&](std::uint64_t perMille) { return (out.count * perMille + 999) / 1000; };
    const std::array<std::uint64_t, 3> ranks{rank(500), rank(990), rank(999)};
    const std::array<std::int64_t*, 3> values{&out.p50_ns, &out.p99_ns, &out.p999_ns};
    std::uint64_t below = 0;
    std::size_t next = 0;
    for (std::size_t i = 0; i < kBins && next < ranks.size(); ++i) {
        below += counts[i];
        while (next < ranks.size() && below >= ranks[next]) {
            *values[next++] = std::min(static_cast<std::int64_t>(topOf(i)), out.max_ns);
        }
    }
    return out;
}

} // namespace palpate::core
