// SPDX-License-Identifier: BSD-3-Clause
#include "SteppedHand.h"

#include <algorithm>

namespace palpate::openigtlink {

namespace {

constexpr double kFastest_mm_per_ns = 5000.0 * 1e-9; // a throw of the arm reaches 10 m/s, palpation 0.5 m/s
constexpr std::int64_t kShortest_ns = 1'000'000;
constexpr std::int64_t kLongest_ns = 200'000'000;

} // namespace

double SteppedHand::share(std::int64_t now_ns) const noexcept
{
    return std::clamp(static_cast<double>(now_ns - m_start_ns) / static_cast<double>(m_over_ns), 0.0, 1.0);
}

device::DeviceState SteppedHand::advance(const Sample& newest, std::int64_t now_ns) noexcept PALPATE_NONBLOCKING
{
    device::DeviceState state;
    state.time_ns = now_ns;
    state.isLost = newest.isLost;
    if (!newest.isPresent || now_ns - newest.time_ns > m_staleAfter_ns) {
        m_isHere = false;
        m_hasArrived = false;
        return state;
    }
    if (!m_isHere || newest.number != m_number) {
        const double at = share(now_ns);
        const core::Vec3 here_D = m_from_D + at * (m_to_D - m_from_D);
        const std::int64_t over_ns = std::clamp(newest.interval_ns, kShortest_ns, kLongest_ns);
        const bool isJump = newest.origin != m_origin ||
                            (newest.p_D - here_D).norm() > kFastest_mm_per_ns * static_cast<double>(over_ns);
        if (m_isHere && isJump) {
            m_isHere = false;
            m_hasArrived = false;
            return state;
        }
        m_from_D = m_isHere ? here_D : newest.p_D;
        m_fromTurn = m_isHere ? core::Quaternion(m_fromTurn.slerp(at, m_toTurn)) : newest.q_D;
        m_to_D = newest.p_D;
        m_toTurn = newest.q_D;
        m_start_ns = now_ns;
        m_over_ns = over_ns;
        m_number = newest.number;
        m_origin = newest.origin;
        m_isHere = true;
    }
    const double at = share(now_ns);
    state.p_D = m_from_D + at * (m_to_D - m_from_D);
    state.q_D = m_fromTurn.slerp(at, m_toTurn);
    state.isPresent = true;
    m_hasArrived = at >= 1.0;
    return state;
}

} // namespace palpate::openigtlink
