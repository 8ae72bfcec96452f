// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/device/SimulatedHand.h"

#include <cmath>
#include <string>
#include <utility>

namespace palpate::device {

using core::Status;
using core::StatusCode;

namespace {

constexpr double kMillimetresPerMetre = 1000.0; // N/kg is m/s^2

} // namespace

SimulatedHand::SimulatedHand(HandScript script, const SimulatedHandOptions& options)
    : m_script(std::move(script))
    , m_options(options)
{
}

DeviceInfo SimulatedHand::info() const
{
    DeviceInfo info = deviceInfo(m_options.preset);
    info.name = "Simulated hand (" + info.name + ")";
    info.id = "simulated-hand";
    info.workspaceRadius_mm = 0.0;
    info.rate_Hz = m_options.rate_Hz;
    return info;
}

Status SimulatedHand::start()
{
    const struct
    {
        const char* name;
        double value;
        double smallest;
    } checks[] = {{"rate_Hz", m_options.rate_Hz, 1.0},
                  {"mass_kg", m_options.mass_kg, 1e-6},
                  {"gripStiffness_N_per_mm", m_options.gripStiffness_N_per_mm, 0.0},
                  {"gripDamping_Ns_per_mm", m_options.gripDamping_Ns_per_mm, 0.0},
                  {"deviceDamping_Ns_per_mm", m_options.deviceDamping_Ns_per_mm, 0.0},
                  {"friction_N", m_options.friction_N, 0.0},
                  {"delayTicks", static_cast<double>(m_options.delayTicks), 0.0},
                  {"resolution_mm", m_options.resolution_mm, 0.0},
                  {"maxForce_N", m_options.preset.maxForce_N, 0.0},
                  {"subSteps", static_cast<double>(m_options.subSteps), 1.0}};
    for (const auto& check : checks) {
        if (!std::isfinite(check.value) || check.value < check.smallest) {
            return {StatusCode::OutOfRange, PALPATE_TEXT("simulated hand: %1: found %2, expected at least %3"),
                    check.name, check.value, check.smallest};
        }
    }
    if (static_cast<std::size_t>(m_options.delayTicks) > kMaxDelayTicks) {
        return {StatusCode::OutOfRange, PALPATE_TEXT("simulated hand: %1: found %2, expected at most %3"), "delayTicks",
                m_options.delayTicks, kMaxDelayTicks};
    }
    m_waiting.fill(Vec3::Zero());
    m_tick = 0;
    m_p_W = m_script.at(0.0).p_W;
    m_v_W.setZero();
    m_f_W.setZero();
    m_isFinished.store(false, std::memory_order_release);
    return {};
}

void SimulatedHand::stop() noexcept
{
    m_f_W.setZero();
}

void SimulatedHand::advance() noexcept PALPATE_NONBLOCKING
{
    const auto from = static_cast<double>(m_tick - 1);
    if (m_options.isRigid) {
        const HandScript::Motion motion = m_script.at(static_cast<double>(m_tick) / m_options.rate_Hz);
        m_p_W = motion.p_W;
        m_v_W = motion.v_W;
        return;
    }
    const double dt_s = 1.0 / (m_options.rate_Hz * m_options.subSteps);
    for (int i = 1; i <= m_options.subSteps; ++i) {
        const HandScript::Motion target =
            m_script.at((from + static_cast<double>(i) / m_options.subSteps) / m_options.rate_Hz);
        const Vec3 f_W = m_f_W + m_options.gripStiffness_N_per_mm * (target.p_W - m_p_W) +
                         m_options.gripDamping_Ns_per_mm * (target.v_W - m_v_W) -
                         m_options.deviceDamping_Ns_per_mm * m_v_W;
        m_v_W += f_W * (kMillimetresPerMetre / m_options.mass_kg * dt_s);
        if (m_options.friction_N > 0.0) {
            const double speed = m_v_W.norm();
            const double lost = m_options.friction_N * (kMillimetresPerMetre / m_options.mass_kg * dt_s);
            m_v_W = speed > lost ? Vec3(m_v_W * (1.0 - lost / speed)) : Vec3(Vec3::Zero());
        }
        m_p_W += m_v_W * dt_s;
    }
}

DeviceState SimulatedHand::read(std::int64_t now_ns) noexcept PALPATE_NONBLOCKING
{
    if (m_tick > 0) {
        advance();
    }
    if (static_cast<double>(m_tick) / m_options.rate_Hz >= m_script.end_s()) {
        m_isFinished.store(true, std::memory_order_release);
    }
    ++m_tick;
    DeviceState state;
    state.p_D = m_p_W;
    if (m_options.resolution_mm > 0.0) {
        for (int axis = 0; axis < 3; ++axis) {
            state.p_D[axis] = std::round(m_p_W[axis] / m_options.resolution_mm) * m_options.resolution_mm;
        }
    }
    state.time_ns = now_ns;
    state.isPresent = true;
    return state;
}

void SimulatedHand::write(const Vec3& f_D) noexcept PALPATE_NONBLOCKING
{
    // Motors saturate; a non-finite force is ignored.
    const double magnitude_N = f_D.norm();
    Vec3 f_W = Vec3::Zero();
    if (std::isfinite(magnitude_N)) {
        f_W = magnitude_N > m_options.preset.maxForce_N ? Vec3(f_D * (m_options.preset.maxForce_N / magnitude_N)) : f_D;
    }
    if (m_options.delayTicks == 0) {
        m_f_W = f_W;
        return;
    }
    // Called after the read of tick m_tick - 1: the force written delayTicks earlier takes effect now.
    Vec3& slot = m_waiting[static_cast<std::size_t>(m_tick % m_options.delayTicks)];
    m_f_W = slot;
    slot = f_W;
}

} // namespace palpate::device
