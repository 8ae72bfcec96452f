// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/Phases.h"

#include "palpate/session/Measures.h"

#include <algorithm>
#include <cmath>

namespace palpate::session {

PhaseSummary summary(const std::vector<Phase>& phases, Phase::Kind kind)
{
    PhaseSummary out;
    double weighted = 0.0;
    for (const Phase& phase : phases) {
        if (phase.kind == kind) {
            ++out.phases;
            out.time_s += phase.time_s;
            out.peakForce_N = std::max(out.peakForce_N, phase.peakForce_N);
            weighted += phase.meanForce_N * phase.time_s;
        }
    }
    out.meanForce_N = out.time_s > 0.0 ? weighted / out.time_s : 0.0;
    return out;
}

PhaseAccumulator::PhaseAccumulator(double dt_s, std::optional<std::int64_t> firstTick)
    : m_dt_s(dt_s)
    , m_blockTicks(std::max<std::int64_t>(1, std::llround(kPhaseBlock_s / dt_s)))
    , m_firstTick(firstTick)
{
}

/// Classifies the open block and appends it as a new phase or extends the previous phase.
void PhaseAccumulator::close(std::vector<Phase>& phases, bool& isOpen) const
{
    if (!m_block) {
        isOpen = false;
        return;
    }
    Phase phase = m_block->phase;
    const double moves_s = static_cast<double>(phase.ticks - 1) * m_dt_s;
    const double speed = moves_s > 0.0 ? (m_block->last_WG - m_block->first_WG).norm() / moves_s : 0.0;
    phase.kind = speed > kSearchSpeed_mm_per_s ? Phase::Kind::Search : Phase::Kind::Press;
    phase.time_s = static_cast<double>(phase.ticks) * m_dt_s;
    phase.meanForce_N = m_block->sumForce_N / static_cast<double>(phase.ticks);
    if (isOpen && m_block->goesOn && !phases.empty() && phases.back().kind == phase.kind) {
        Phase& before = phases.back();
        before.meanForce_N = (before.meanForce_N * static_cast<double>(before.ticks) + m_block->sumForce_N) /
                             static_cast<double>(before.ticks + phase.ticks);
        before.ticks += phase.ticks;
        before.time_s = static_cast<double>(before.ticks) * m_dt_s;
        before.peakForce_N = std::max(before.peakForce_N, phase.peakForce_N);
    } else {
        phases.push_back(phase);
    }
    isOpen = true;
}

void PhaseAccumulator::add(const servo::TickRecord& tick)
{
    take(tick, tick.felt.structure < 0 ? std::nullopt : std::optional(Touch{tick.felt.p_WG, tick.felt.f_W.norm()}));
}

void PhaseAccumulator::add(const servo::TickRecord& tick, const haptics::Contact* touched)
{
    take(tick, touched == nullptr ? std::nullopt : std::optional(Touch{touched->p_WG, touched->f_W.norm()}));
}

void PhaseAccumulator::take(const servo::TickRecord& tick, const std::optional<Touch>& touch)
{
    m_firstTick = m_firstTick.value_or(tick.tick);
    const bool goesOn = follows(m_previous, tick) && m_wasTouching;
    m_previous = tick;
    m_wasTouching = touch.has_value();
    if (!touch || !goesOn || (m_block && m_block->phase.ticks == m_blockTicks)) {
        close(m_phases, m_isOpen);
        m_block.reset();
    }
    if (!touch) {
        m_isOpen = false;
        return;
    }
    if (!m_block) {
        m_block = Block{};
        m_block->goesOn = goesOn;
        m_block->first_WG = touch->p_WG;
        m_block->phase.firstTick = tick.tick;
        m_block->phase.start_s = static_cast<double>(tick.tick - *m_firstTick) * m_dt_s;
    }
    m_block->last_WG = touch->p_WG;
    m_block->sumForce_N += touch->force_N;
    m_block->phase.peakForce_N = std::max(m_block->phase.peakForce_N, touch->force_N);
    ++m_block->phase.ticks;
}

std::vector<Phase> PhaseAccumulator::result() const
{
    std::vector<Phase> phases = m_phases;
    bool isOpen = m_isOpen;
    close(phases, isOpen);
    return phases;
}

} // namespace palpate::session
