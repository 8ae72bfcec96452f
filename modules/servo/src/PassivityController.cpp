// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/servo/PassivityController.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate::servo {

PassivityLimits PassivityLimits::forDevice(const device::DeviceInfo& info) noexcept
{
    PassivityLimits limits;
    limits.isOn = info.actuatedAxes > 0;
    limits.ownDamping_Ns_per_mm = std::max(0.0, info.ownDamping_Ns_per_mm);
    if (info.maxDamping_Ns_per_mm > 0.0) {
        limits.maxDamping_Ns_per_mm = info.maxDamping_Ns_per_mm;
    }
    limits.resolution_mm = std::max(0.0, info.resolution_mm);
    return limits;
}

namespace {

/// The maximum damping stated by a manufacturer refers to 1 kHz; at longer periods damping itself causes oscillation.
double dampingAt(double maxDamping_Ns_per_mm, double dt_s) noexcept
{
    constexpr double kStated_s = 0.001;
    return maxDamping_Ns_per_mm * std::min(1.0, kStated_s / dt_s);
}

} // namespace

PassivityController::PassivityController(const PassivityLimits& limits, double dt_s) noexcept
    : m_limits(limits)
    , m_dt_s(dt_s)
    , m_motion(limits.resolution_mm)
{
    m_limits.maxDamping_Ns_per_mm = dampingAt(limits.maxDamping_Ns_per_mm, dt_s);
    setDelay(limits.delayTicks);
    reset();
}

const MotionTrack& PassivityController::follow(const Vec3& p_WH) noexcept PALPATE_NONBLOCKING
{
    if (p_WH.allFinite()) {
        m_motion.step(p_WH);
    } else {
        reset();
    }
    return m_motion;
}

Vec3 PassivityController::damping(const Vec3& fAsked_W, bool isInContact) noexcept PALPATE_NONBLOCKING
{
    m_state.damping_Ns_per_mm = 0.0;
    if (!fAsked_W.allFinite()) {
        reset();
        return Vec3::Zero();
    }
    const Vec3& dx = m_motion.moved();
    const double work = m_sent_W[static_cast<std::size_t>(m_limits.delayTicks)].dot(dx);
    const double meant = 0.5 * (m_fAsked_W + fAsked_W).dot(dx);
    const double d2 = dx.squaredNorm();
    const double own = m_limits.ownDamping_Ns_per_mm * d2 / m_dt_s;
    m_state.energy_mJ += own - work;
    m_state.excess_mJ = std::max(0.0, m_state.excess_mJ + work - meant - own);
    m_fAsked_W = fAsked_W;
    if (!isInContact) {
        m_state.energy_mJ = 0.0;
        m_state.excess_mJ = 0.0;
    }
    const double tooMuch_mJ = std::max(m_state.excess_mJ, -m_state.energy_mJ);
    if (!m_limits.isOn || !(tooMuch_mJ > 0.0) || !(d2 > 0.0)) {
        return Vec3::Zero();
    }
    // Spread over the window of the motion estimate: a sensor step is the motion of several ticks.
    const double perTick_mJ = tooMuch_mJ / m_motion.window();
    m_state.damping_Ns_per_mm = std::min(perTick_mJ * m_dt_s / d2, m_limits.maxDamping_Ns_per_mm);
    return -m_state.damping_Ns_per_mm / m_dt_s * dx;
}

void PassivityController::setDelay(int ticks) noexcept PALPATE_NONBLOCKING
{
    m_limits.delayTicks = std::clamp(ticks, 0, kMaxDelayTicks);
}

void PassivityController::noteSent(const Vec3& fSent_W) noexcept PALPATE_NONBLOCKING
{
    std::copy_backward(m_sent_W.begin(), m_sent_W.end() - 1, m_sent_W.end());
    m_sent_W[0] = fSent_W;
}

void PassivityController::noteStored(double energy_mJ) noexcept PALPATE_NONBLOCKING
{
    m_state.energy_mJ = std::max(m_state.energy_mJ, energy_mJ);
}

void PassivityController::reset() noexcept PALPATE_NONBLOCKING
{
    m_state = {};
    m_motion.reset();
    m_fAsked_W.setZero();
    m_sent_W.fill(Vec3::Zero());
}

double passiveStiffness_N_per_mm(double b_Ns_per_mm, double B_Ns_per_mm, double dt_s) noexcept
{
    return std::max(0.0, 2.0 * (b_Ns_per_mm - std::abs(B_Ns_per_mm)) / dt_s);
}

double stableStiffness_N_per_mm(double damping_Ns_per_mm, double dt_s, double delay_s) noexcept
{
    return std::max(0.0, damping_Ns_per_mm / (0.5 * dt_s + delay_s));
}

double heldStiffness_N_per_mm(const device::DeviceInfo& info, double rate_Hz, bool isControlled,
                              int delayTicks) noexcept
{
    constexpr double kShare = 0.7;
    constexpr double kSureDamping_Ns_per_mm = 0.01;
    constexpr double kFine_mm = 0.04;
    if (info.actuatedAxes == 0 || !(rate_Hz > 0.0)) {
        return std::numeric_limits<double>::infinity();
    }
    const PassivityLimits limits = PassivityLimits::forDevice(info);
    const double dt_s = 1.0 / rate_Hz;
    double damping = limits.ownDamping_Ns_per_mm;
    if (isControlled) {
        const double told = limits.resolution_mm > kFine_mm ? kFine_mm / limits.resolution_mm : 1.0;
        damping += told * dampingAt(std::min(limits.maxDamping_Ns_per_mm, kSureDamping_Ns_per_mm), dt_s);
    }
    const double held = kShare * stableStiffness_N_per_mm(damping, dt_s, delayTicks * dt_s);
    return info.maxStiffness_N_per_mm > 0.0 ? std::min(held, info.maxStiffness_N_per_mm) : held;
}

int delayTicksOf(const core::TimingSummary& latency, double rate_Hz) noexcept
{
    constexpr std::uint64_t kEnough = 1000;
    constexpr double kBin = 0.01; // a percentile may exceed the measured value by one bin
    constexpr double kMost = 1000.0;
    if (latency.count < kEnough) {
        return 1;
    }
    const double ticks = static_cast<double>(latency.p99_ns) * 1e-9 * rate_Hz;
    return static_cast<int>(std::clamp(std::ceil(ticks * (1.0 - kBin)), 1.0, kMost));
}

} // namespace palpate::servo
