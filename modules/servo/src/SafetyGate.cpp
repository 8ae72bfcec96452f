// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/servo/SafetyGate.h"

#include <algorithm>
#include <cmath>

namespace palpate::servo {

namespace {

double positiveOrZero(double value) noexcept
{
    return std::isfinite(value) && value > 0.0 ? value : 0.0;
}

/// Limits `v` to `length`, for any finite `v`.
Vec3 shortened(Vec3 v, double length) noexcept
{
    const double largest = v.cwiseAbs().maxCoeff();
    if (largest > length) {
        v *= length / largest; // prevents overflow of the norm below
    }
    const double norm = v.norm();
    return norm > length ? Vec3(v * (length / norm)) : v;
}

} // namespace

GateLimits GateLimits::forDevice(const device::DeviceInfo& info)
{
    constexpr double kFullForceIn_s = 0.005;
    constexpr double kHandAway_mm_per_s = 1000.0;
    constexpr double kWorkspaceMargin = 1.5;
    GateLimits limits;
    limits.maxForce_N = positiveOrZero(info.maxForce_N);
    limits.maxForceRate_N_per_s = limits.maxForce_N / kFullForceIn_s;
    limits.maxPower_Nmm_per_s = limits.maxForce_N * kHandAway_mm_per_s;
    limits.workspaceRadius_mm = kWorkspaceMargin * positiveOrZero(info.workspaceRadius_mm);
    if (info.actuatedAxes == 0) {
        limits.jumpRule = JumpRule::Follow;
        limits.overrunRun = 0;
    }
    return limits;
}

SafetyGate::SafetyGate(const GateLimits& limits, double dt_s) noexcept
    : m_limits(limits)
    , m_dt_s(dt_s)
    , m_passed_s(dt_s)
{
}

GatedInput SafetyGate::admit(const device::DeviceState& state, std::int64_t now_ns) noexcept PALPATE_NONBLOCKING
{
    GatedInput input;
    // In double: the difference of arbitrary 64-bit times may overflow, and a precision of 0.1 us is sufficient.
    m_passed_s = std::max(m_dt_s, (static_cast<double>(now_ns) - static_cast<double>(m_now_ns)) * 1e-9);
    m_now_ns = now_ns;
    m_isPresent = false;
    m_v_D.setZero();
    if (state.isLost) {
        raise(FaultKind::DeviceLost);
    }
    if (!state.isPresent || state.isLost) {
        m_hasHand = false;
        m_refused = 0;
        return input;
    }

    const double age_s = (static_cast<double>(now_ns) - static_cast<double>(state.time_ns)) * 1e-9;
    Vec3 p_D = state.p_D;
    bool isRefused = true;
    if (!p_D.allFinite()) {
        raise(FaultKind::NonFiniteInput);
    } else if (!(std::abs(age_s) <= m_limits.staleAfter_s)) { // a future time comes from another clock
        raise(FaultKind::StaleInput);
    } else if (p_D.cwiseAbs().maxCoeff() > m_limits.largestCoordinate_mm ||
               (m_limits.workspaceRadius_mm > 0.0 && p_D.norm() > m_limits.workspaceRadius_mm)) {
        refuse(FaultKind::OutOfWorkspace);
    } else if (m_hasHand) {
        // A late tick or a slow device gives the hand more time to move, bounded by the age of a stale HIP.
        const double since_s = std::clamp((static_cast<double>(state.time_ns) - static_cast<double>(m_time_ns)) * 1e-9,
                                          m_dt_s, std::max(m_dt_s, m_limits.staleAfter_s));
        const double reach_mm = m_limits.maxHandSpeed_mm_per_s * since_s;
        const Vec3 move = p_D - m_p_D;
        if (move.norm() <= reach_mm) {
            isRefused = false;
        } else if (m_limits.jumpRule == JumpRule::Follow) {
            p_D = m_p_D + shortened(move, reach_mm);
            input.isGated = true;
            isRefused = false;
        } else {
            refuse(FaultKind::InputJump);
        }
    } else {
        isRefused = false;
    }

    if (isRefused) {
        input.isGated = true;
        input.isPresent = m_hasHand;
        input.p_D = m_hasHand ? m_p_D : Vec3(Vec3::Zero());
        m_isPresent = m_hasHand;
        return input;
    }
    input.isPresent = true;
    input.isFirst = !m_hasHand;
    input.p_D = p_D;
    if (m_hasHand) {
        m_v_D = (p_D - m_p_D) / m_dt_s;
    } else {
        m_gain = 0.0;
        m_wasInContact = false;
    }
    m_hasHand = true;
    m_isPresent = true;
    m_refused = 0;
    m_p_D = p_D;
    m_time_ns = state.time_ns;
    return input;
}

double SafetyGate::nextGain() const noexcept
{
    return m_limits.easeIn_s > 0.0 ? std::min(1.0, m_gain + m_dt_s / m_limits.easeIn_s) : 1.0;
}

Vec3 SafetyGate::eased(const Vec3& f_D) const noexcept PALPATE_NONBLOCKING
{
    return nextGain() * shortened(f_D, m_limits.maxForce_N);
}

Vec3 SafetyGate::release(const ForceRequest& request) noexcept PALPATE_NONBLOCKING
{
    const double largestChange_N = m_limits.maxForceRate_N_per_s * m_dt_s;
    const bool isFirstContact =
        request.isInContact && !m_wasInContact && !request.isSceneChanged && m_sent_D.norm() <= largestChange_N;
    m_wasInContact = request.isInContact;

    if (!request.f_D.allFinite()) {
        raise(FaultKind::NonFiniteForce);
    }
    if (!m_isPresent) {
        m_rampLeft_s = 0.0;
        m_sent_D.setZero();
        return m_sent_D;
    }
    Vec3 f_D = Vec3::Zero();
    if (m_fault != FaultKind::None || m_isStopping) {
        // Start from the last sent force, so that the ramp never rises after a reduction by the power bound. Use
        // the tick time, so that late ticks do not prolong the ramp.
        constexpr double kRounding = 1.0 + 1e-9;
        if (m_rampLeft_s > kRounding * m_passed_s) {
            f_D = m_sent_D * (1.0 - m_passed_s / m_rampLeft_s);
            m_rampLeft_s -= m_passed_s;
        } else {
            m_rampLeft_s = 0.0;
        }
    } else {
        f_D = eased(request.f_D);
        m_gain = nextGain();
        if (!isFirstContact) {
            const Vec3 change = f_D - m_sent_D;
            const double change_N = change.norm();
            if (change_N > largestChange_N) {
                f_D = m_sent_D + change * (largestChange_N / change_N);
            }
        }
        f_D = shortened(f_D, m_limits.maxForce_N); // again, because of rounding
    }
    const double power = f_D.dot(m_v_D);
    if (power > m_limits.maxPower_Nmm_per_s) {
        f_D *= m_limits.maxPower_Nmm_per_s / power;
    }
    m_sent_D = f_D.allFinite() ? f_D : Vec3(Vec3::Zero()); // final check, independent of the limits
    return m_sent_D;
}

void SafetyGate::noteOverrun(bool isOverrun) noexcept PALPATE_NONBLOCKING
{
    m_overruns = isOverrun ? m_overruns + 1 : 0;
    if (m_limits.overrunRun > 0 && m_overruns >= m_limits.overrunRun) {
        raise(FaultKind::OverrunRun);
    }
}

void SafetyGate::raise(FaultKind kind) noexcept PALPATE_NONBLOCKING
{
    if (m_fault == FaultKind::None && kind != FaultKind::None) {
        if (!m_isStopping) {
            m_rampLeft_s = m_limits.rampDown_s;
        }
        m_fault = kind;
    }
}

void SafetyGate::rearm() noexcept PALPATE_NONBLOCKING
{
    m_fault = FaultKind::None;
    m_hasHand = false;
    m_refused = 0;
    m_overruns = 0;
}

void SafetyGate::restartEaseIn() noexcept PALPATE_NONBLOCKING
{
    m_gain = 0.0;
    m_wasInContact = false;
}

void SafetyGate::beginStop() noexcept PALPATE_NONBLOCKING
{
    if (!m_isStopping && m_fault == FaultKind::None) {
        m_rampLeft_s = m_limits.rampDown_s;
    }
    m_isStopping = true;
}

bool SafetyGate::isAtRest() const noexcept
{
    return (m_isStopping || m_fault != FaultKind::None) && m_sent_D.isZero(0.0);
}

void SafetyGate::refuse(FaultKind kind) noexcept
{
    if (++m_refused >= m_limits.refusedRun) {
        raise(kind);
    }
}

} // namespace palpate::servo
