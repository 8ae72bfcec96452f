// SPDX-License-Identifier: BSD-3-Clause
#include "RateHand.h"

#include <algorithm>
#include <cmath>

namespace palpate::spacemouse {

namespace {

constexpr double kLongestStep_s = 0.05; // prevents a jump after the thread was delayed

core::Vec3 beyondDeadZone(const core::Vec3& way, double deadZone) noexcept
{
    core::Vec3 rate;
    for (int i = 0; i < 3; ++i) {
        const double past = std::abs(way[i]) - deadZone;
        rate[i] = past > 0.0 ? std::copysign(past / (1.0 - deadZone), way[i]) : 0.0;
    }
    return rate;
}

} // namespace

device::DeviceState RateHand::advance(const Held& held, std::int64_t held_ns,
                                      std::int64_t now_ns) noexcept PALPATE_NONBLOCKING
{
    const double dt_s =
        m_now_ns == 0 ? 0.0 : std::clamp(static_cast<double>(now_ns - m_now_ns) * 1e-9, 0.0, kLongestStep_s);
    m_now_ns = now_ns;
    const bool isStale = static_cast<double>(now_ns - held_ns) * 1e-9 > m_settings.staleAfter_s;
    if (!isStale) {
        m_state.p_D += beyondDeadZone(held.shift, m_settings.deadZone) * (m_settings.speed_mm_per_s * dt_s);
        const double far = m_state.p_D.norm();
        if (far > m_settings.reach_mm) {
            m_state.p_D *= m_settings.reach_mm / far;
        }
        const core::Vec3 turn = beyondDeadZone(held.turn, m_settings.deadZone) * (m_settings.turn_rad_per_s * dt_s);
        if (const double angle = turn.norm(); angle > 0.0) {
            m_state.q_D = (core::Quaternion(Eigen::AngleAxisd(angle, turn / angle)) * m_state.q_D).normalized();
        }
    }
    m_state.buttons = held.buttons;
    m_state.time_ns = now_ns; // a resting pose is still up to date
    m_state.isPresent = !m_isNew;
    m_isNew = false;
    return m_state;
}

void RateHand::recentre() noexcept PALPATE_NONBLOCKING
{
    m_state.p_D.setZero();
    m_state.q_D.setIdentity();
    m_now_ns = 0;
    m_isNew = true;
}

} // namespace palpate::spacemouse
