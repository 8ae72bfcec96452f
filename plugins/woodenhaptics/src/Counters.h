// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <array>
#include <cstdint>

namespace palpate::woodenhaptics {

using RawCounts = std::array<std::int16_t, 3>;

/// Unwraps the device's 16-bit counters and rejects physically impossible steps. A single accepted outlier would
/// offset all later counts by a full wrap.
class Counters
{
  public:
    enum class Answer
    {
        Taken,
        Refused,   ///< jumped: the counts are unchanged
        Restarted, ///< the counters continue from other values; a new calibration is required
    };

    /// @param fastest_per_s  maximum rate of each counter [counts/s]
    explicit Counters(const core::Vec3& fastest_per_s)
        : m_fastest_per_s(fastest_per_s)
    {
    }

    Answer take(const RawCounts& raw, std::int64_t now_ns) noexcept;
    /// Restarts from raw values, which become the current counts.
    void restart(const RawCounts& raw, std::int64_t now_ns) noexcept;
    /// Unwrapped counts. They start at the first raw values.
    [[nodiscard]] core::Vec3 counts() const noexcept { return m_counts; }

  private:
    [[nodiscard]] bool isNear(const RawCounts& from, const RawCounts& to, double seconds) const noexcept;

    core::Vec3 m_fastest_per_s;
    core::Vec3 m_counts = core::Vec3::Zero();
    RawCounts m_raw{};
    RawCounts m_rejected{};     ///< latest rejected values
    std::int64_t m_time_ns = 0; ///< time of the latest accepted report
    std::int64_t m_seen_ns = 0; ///< time of the latest report, accepted or not
    std::int64_t m_rejected_ns = 0;
    int m_consistentCount = 0; ///< consecutive rejected reports that are consistent with each other
    bool m_hasBegun = false;
};

} // namespace palpate::woodenhaptics
