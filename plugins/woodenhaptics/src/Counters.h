// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <array>
#include <cstdint>

namespace palpate::woodenhaptics {

using RawCounts = std::array<std::int16_t, 3>;

/// Turns the device's 16-bit counters, which wrap, into counts that do not, and refuses what no arm can have turned:
/// one wild report taken for true would put every later one a whole wrap aside.
class Counters
{
  public:
    enum class Answer
    {
        Taken,
        Refused,   ///< jumped: the counts stay as they were
        Restarted, ///< the counters go on from elsewhere; what the counts mean has to be calibrated anew
    };

    /// @param fastest_per_s  counts that each counter can move in a second
    explicit Counters(const core::Vec3& fastest_per_s)
        : m_fastest_per_s(fastest_per_s)
    {
    }

    Answer take(const RawCounts& raw, std::int64_t now_ns) noexcept;
    /// Goes on from here: the next raw values mean these counts.
    void restart(const RawCounts& raw, std::int64_t now_ns) noexcept;
    /// Counts since they began, which was at the raw values themselves.
    [[nodiscard]] core::Vec3 counts() const noexcept { return m_counts; }

  private:
    [[nodiscard]] bool isNear(const RawCounts& from, const RawCounts& to, double seconds) const noexcept;

    core::Vec3 m_fastest_per_s;
    core::Vec3 m_counts = core::Vec3::Zero();
    RawCounts m_raw{};
    RawCounts m_elsewhere{};    ///< newest refused
    std::int64_t m_time_ns = 0; ///< of the newest taken
    std::int64_t m_seen_ns = 0; ///< of the newest, taken or not
    std::int64_t m_elsewhere_ns = 0;
    int m_agreeing = 0; ///< refused in a row that follow each other
    bool m_hasBegun = false;
};

} // namespace palpate::woodenhaptics
