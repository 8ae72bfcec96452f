// SPDX-License-Identifier: BSD-3-Clause
#include "Counters.h"

#include <algorithm>
#include <cstdlib>

namespace palpate::woodenhaptics {

namespace {

constexpr int kAgreeingToBegin = 3;
constexpr int kAgreeingToRestart = 10; // 10 ms at a report a millisecond
// While reports come and are refused, an arm that really moved was seen moving: only a share of that time counts, which
// a hand at 2 m/s needs to get through wild reports, and which a restart of the counters does not outrun.
constexpr double kShareOfRefusedTime = 0.2;
constexpr double kLongestGap_s = 0.05; // after a longer one a hand may be anywhere, but no farther than this allows

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
        if (std::abs(step(from[i], to[i])) > std::min(limit, 16384.0)) { // beyond half a wrap no step is told from two
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
    m_agreeing = 0;
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
        m_agreeing = 0;
        return Answer::Taken;
    }
    m_agreeing = m_agreeing > 0 && isNear(m_elsewhere, raw, since(m_elsewhere_ns)) ? m_agreeing + 1 : 1;
    m_elsewhere = raw;
    m_elsewhere_ns = now_ns;
    if (m_agreeing < (m_hasBegun ? kAgreeingToRestart : kAgreeingToBegin)) {
        return Answer::Refused;
    }
    const bool isFirst = !m_hasBegun;
    restart(raw, now_ns);
    return isFirst ? Answer::Taken : Answer::Restarted;
}

} // namespace palpate::woodenhaptics
