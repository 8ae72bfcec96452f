// SPDX-License-Identifier: BSD-3-Clause
#include "Counters.h"

#include <algorithm>
#include <cstdlib>

namespace palpate::woodenhaptics {

namespace {

constexpr int kAgreeingToBegin = 3;
constexpr int kAgreeingToRestart = 10; // 10 ms at one report per millisecond
// While reports arrive but are rejected, real motion would have been seen. Only this fraction of the elapsed time
// counts: enough for a hand at 2 m/s between invalid reports, too little for restarted counters to be accepted as
// motion.
constexpr double kShareOfRefusedTime = 0.2;
constexpr double kLongestGap_s = 0.05; // upper limit of the time, and so of the accepted motion, after a longer gap

int step(std::int16_t from, std::int16_t to) noexcept
{
    return static_cast<std::int16_t>(static_cast<std::uint16_t>(to) - static_cast<std::uint16_t>(from));
}

} // namespace

bool Counters::isNear(const RawCounts& from, const RawCounts& to, double seconds) const noexcept
{
    constexpr double kLeast_s = 0.001;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const double limit =
            m_fastest_per_s[static_cast<Eigen::Index>(i)] * std::clamp(seconds, kLeast_s, kLongestGap_s);
        // At most a quarter wrap: beyond half a wrap (32768 counts) the direction of a step is ambiguous.
        if (std::abs(step(from[i], to[i])) > std::min(limit, 16384.0)) {
            return false;
        }
    }
    return true;
}

void Counters::restart(const RawCounts& raw, std::int64_t now_ns) noexcept
{
    m_raw = raw;
    m_time_ns = now_ns;
    m_seen_ns = now_ns;
    m_counts = core::Vec3(raw[0], raw[1], raw[2]);
    m_consistentCount = 0;
    m_hasBegun = true;
}

Counters::Answer Counters::take(const RawCounts& raw, std::int64_t now_ns) noexcept
{
    const auto since = [now_ns](std::int64_t then_ns) { return static_cast<double>(now_ns - then_ns) * 1e-9; };
    const double quiet_s = since(m_seen_ns);
    const double allowed_s = quiet_s + kShareOfRefusedTime * (since(m_time_ns) - quiet_s);
    m_seen_ns = now_ns;
    if (m_hasBegun && isNear(m_raw, raw, allowed_s)) {
        for (std::size_t i = 0; i < raw.size(); ++i) {
            m_counts[static_cast<Eigen::Index>(i)] += step(m_raw[i], raw[i]);
        }
        m_raw = raw;
        m_time_ns = now_ns;
        m_consistentCount = 0;
        return Answer::Taken;
    }
    m_consistentCount =
        m_consistentCount > 0 && isNear(m_rejected, raw, since(m_rejected_ns)) ? m_consistentCount + 1 : 1;
    m_rejected = raw;
    m_rejected_ns = now_ns;
    if (m_consistentCount < (m_hasBegun ? kAgreeingToRestart : kAgreeingToBegin)) {
        return Answer::Refused;
    }
    const bool isFirst = !m_hasBegun;
    restart(raw, now_ns);
    return isFirst ? Answer::Taken : Answer::Restarted;
}

} // namespace palpate::woodenhaptics
