// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/servo/ServoCore.h"

#include "FlushDenormals.h"

#include <palpate/core/Clock.h>

#include <algorithm>
#include <utility>

namespace palpate::servo {

namespace {

const haptics::TickResult kNothingFelt{};

} // namespace

void feelTick(haptics::Palpator& palpator, double dt_s, TickRecord& tick) noexcept PALPATE_NONBLOCKING
{
    tick.felt = kNothingFelt;
    tick.solve_ns = 0;
    if ((tick.flags & kNoHand) != 0) {
        return;
    }
    const std::int64_t begin_ns = core::monotonicNow_ns();
    {
        const FlushDenormals flushed;
        if ((tick.flags & kReset) != 0) {
            palpator.reset();
        }
        // Time counts ticks, so that a replay moves the tissue alike.
        const double time_s = static_cast<double>(tick.tick) * dt_s;
        tick.felt = palpator.step(tick.p_WH, dt_s, &tick.v_WH, time_s);
    }
    tick.solve_ns = core::shortDuration_ns(core::monotonicNow_ns() - begin_ns);
    if (tick.felt.contactCount == 0) {
        tick.v_WH.setZero(); // no damping, so the velocity is not recorded
    }
    if (tick.felt.status == haptics::TickStatus::IterationLimit) {
        tick.flags |= kIterationLimit;
    }
    switch (tick.felt.friction()) {
    case haptics::Friction::Slides:
        tick.flags |= kSlides;
        break;
    case haptics::Friction::Holds:
        tick.flags |= kHolds;
        break;
    case haptics::Friction::None:
        break;
    }
}

ServoCore::ServoCore(const GateLimits& limits, double rate_Hz, const PassivityLimits& passivity) noexcept
    : m_gate(limits, 1.0 / rate_Hz)
    , m_passivity(passivity, 1.0 / rate_Hz)
    , m_dt_s(1.0 / rate_Hz)
{
}

void ServoCore::borrowScene(const haptics::HapticScene* scene, std::uint32_t generation) noexcept PALPATE_NONBLOCKING
{
    if (m_palpator.borrowScene(scene)) {
        m_gate.restartEaseIn();
    }
    m_generation = generation;
    m_isSceneChanged = true;
}

TickRecord ServoCore::tick(const device::DeviceState& state, std::int64_t now_ns) noexcept PALPATE_NONBLOCKING
{
    TickRecord record;
    record.tick = m_tick++;
    record.time_ns = now_ns;
    record.scene = m_generation;

    unsigned flags = 0;
    if (m_isSceneChanged) {
        flags |= kSceneChanged;
    }
    const GatedInput input = m_gate.admit(state, now_ns);
    if (input.isGated) {
        flags |= kInputGated;
    }
    MappedInput mapped;
    if (!input.isPresent) {
        flags |= kNoHand;
        m_away_s += m_gate.fault() == FaultKind::None ? m_dt_s : 0.0;
    } else {
        mapped = m_map.map(input, state.buttons);
        flags |= mapped.isMoved && !(input.isFirst && isBack(mapped.p_W)) ? unsigned{kReset} : 0U;
        m_away_s = 0.0;
        m_p_WH = mapped.p_W;
        m_hasBeenHere = true;
        flags |= mapped.isClutched ? unsigned{kClutched} : 0U;
        record.p_WH = mapped.p_W;
        record.buttons = state.buttons;
        if (mapped.isReleased || mapped.isMoved) {
            m_gate.restartEaseIn();
        }
    }

    // While clutched, the device moves freely and the god-object stays in place.
    const bool isFelt = input.isPresent && !mapped.isClutched;
    if (!isFelt || mapped.isMoved || mapped.isReleased) {
        m_passivity.reset();
        m_tissuePower_mW = 0.0;
    }
    if (isFelt) {
        const MotionTrack& motion = m_passivity.follow(input.p_D);
        if (m_palpator.scene() != nullptr && m_palpator.scene()->isDamped()) {
            record.v_WH = m_map.scale() * m_map.toScene(motion.slope()) / m_dt_s;
        }
    }
    record.flags = static_cast<std::uint16_t>(flags);
    feelTick(m_palpator, m_dt_s, record);
    flags = record.flags;
    const haptics::TickResult& felt = record.felt;

    ForceRequest request;
    request.isInContact = isFelt && felt.structure >= 0;
    request.isSceneChanged = m_isSceneChanged;
    if (isFelt) {
        request.f_D = m_map.toDevice(felt.f_W);
        if (m_isSceneChanged) { // energy stored in the springs, in device lengths
            m_passivity.noteStored(0.5 * felt.f_W.dot(felt.p_WG - mapped.p_W) / m_map.scale());
        }
        if (m_palpator.scene() != nullptr && m_palpator.scene()->isMoving()) {
            m_passivity.noteWork(tissueWork_mJ(request.f_D));
        }
        const Vec3 damping_D = m_passivity.damping(m_gate.eased(request.f_D), request.isInContact);
        record.fDamping_W = m_map.toScene(damping_D);
        record.energy_mJ = m_passivity.state().energy_mJ;
        request.f_D += damping_D;
    }
    m_sent_D = m_gate.release(request);
    m_passivity.noteSent(m_sent_D);
    record.fSent_W = m_map.toScene(m_sent_D);
    if (record.fSent_W != felt.f_W) {
        flags |= kOutputGated;
    }
    record.flags = static_cast<std::uint16_t>(flags);
    m_isSceneChanged = false;
    latch(record.tick, now_ns);
    return record;
}

/// Returns the energy that moving tissue put into the contacts since the last tick, in device lengths and for the share
/// of the force that the gate lets through [mJ].
double ServoCore::tissueWork_mJ(const Vec3& f_D) noexcept
{
    const double asked_N = f_D.norm();
    const double share = asked_N > 0.0 ? std::min(1.0, m_gate.eased(f_D).norm() / asked_N) : 1.0;
    const double now_mW = share * m_palpator.tissuePower_mW() / m_map.scale();
    return 0.5 * (std::exchange(m_tissuePower_mW, now_mW) + now_mW) * m_dt_s;
}

/// @return true when a hand returns to within Palpator::kNear_mm of its last position, too soon to have moved around
/// the touched object. There is no time limit on an open surface, where only the remembered side indicates contact.
/// Time in a fault does not count, because the hand waits for re-arming.
bool ServoCore::isBack(const Vec3& p_WH) const noexcept
{
    constexpr double kLongest_s = 0.5;
    constexpr double kRounding = 1.0 + 1e-9; // tolerance for the rounding of a sum of periods
    return m_hasBeenHere && (p_WH - m_p_WH).norm() <= haptics::Palpator::kNear_mm &&
           (m_away_s <= kRounding * kLongest_s || m_palpator.isOnSheet());
}

ServoHand ServoCore::hand() const noexcept
{
    return {m_palpator.state(), m_map, m_p_WH, m_away_s, m_hasBeenHere};
}

void ServoCore::resume(const ServoHand& hand) noexcept
{
    m_palpator.restore(hand.palpator);
    m_map = hand.map;
    m_p_WH = hand.p_WH;
    m_away_s = hand.away_s;
    m_hasBeenHere = hand.hasBeenHere;
}

void ServoCore::noteOverrun(bool isOverrun, std::int64_t now_ns) noexcept PALPATE_NONBLOCKING
{
    m_gate.noteOverrun(isOverrun);
    latch(m_tick - 1, now_ns);
}

void ServoCore::rearm() noexcept PALPATE_NONBLOCKING
{
    m_gate.rearm();
    m_fault = {};
}

void ServoCore::latch(std::int64_t tick, std::int64_t now_ns) noexcept
{
    if (m_fault.kind == FaultKind::None && m_gate.fault() != FaultKind::None) {
        m_fault = {m_gate.fault(), tick, now_ns};
    }
}

} // namespace palpate::servo
