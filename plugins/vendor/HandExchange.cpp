// SPDX-License-Identifier: BSD-3-Clause
#include "HandExchange.h"

#include <palpate/core/Clock.h>

namespace palpate::vendor {

namespace {

constexpr std::int64_t kForceTimeout_ns = 8'000'000;

} // namespace

void HandExchange::reset()
{
    m_latency.clear();
    m_readState_ns = 0;
    m_answered_ns = 0;
    m_push.write(ForceCommand{});
    m_state.write(device::DeviceState{});
}

device::DeviceState HandExchange::read() noexcept PALPATE_NONBLOCKING
{
    m_state.fetch();
    const device::DeviceState state = m_state.value().get();
    m_readState_ns = state.time_ns;
    return state;
}

void HandExchange::write(const core::Vec3& f_D) noexcept PALPATE_NONBLOCKING
{
    m_push.write(ForceCommand{f_D, m_readState_ns, core::monotonicNow_ns()});
}

void HandExchange::publish(const device::DeviceState& state) noexcept PALPATE_NONBLOCKING
{
    m_state.write(state);
}

core::Vec3 HandExchange::wantedForce(std::int64_t now_ns, double maxForce_N) noexcept PALPATE_NONBLOCKING
{
    m_push.fetch();
    const ForceCommand push = m_push.value().get();
    if (now_ns - push.time_ns >= kForceTimeout_ns || !push.f_D.allFinite()) {
        return core::Vec3::Zero();
    }
    const double force_N = push.f_D.norm();
    return force_N > maxForce_N ? core::Vec3(push.f_D * (maxForce_N / force_N)) : push.f_D;
}

void HandExchange::noteSent(const core::Vec3& f_D, std::int64_t now_ns) noexcept PALPATE_NONBLOCKING
{
    const std::int64_t answers_ns = m_push.value().get().answers_ns;
    if (!f_D.isZero(0.0) && answers_ns > m_answered_ns) {
        m_answered_ns = answers_ns;
        m_latency.add(now_ns - answers_ns);
    }
}

} // namespace palpate::vendor
