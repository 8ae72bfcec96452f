// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/Measures.h"

#include <algorithm>
#include <cmath>

namespace palpate::session {

MeasureAccumulator::MeasureAccumulator(double dt_s)
    : m_dt_s(dt_s)
{
}

void MeasureAccumulator::add(const servo::TickRecord& tick, std::string_view structure)
{
    ++m_sum.ticks;
    constexpr int kStartsAnew = servo::kNoHand | servo::kReset | servo::kDroppedBefore;
    const bool follows = m_previous && m_previous->tick + 1 == tick.tick && (tick.flags & kStartsAnew) == 0 &&
                         (m_previous->flags & servo::kNoHand) == 0;
    if (follows) {
        m_sum.pathLength_mm += (tick.p_WH - m_previous->p_WH).norm();
        if (tick.structure >= 0 && m_previous->structure >= 0) {
            m_sum.contactPath_mm += (tick.p_WG - m_previous->p_WG).norm();
        }
    }
    m_previous = tick;
    if (tick.structure < 0) {
        return;
    }
    const double force = tick.f_W.norm();
    const double depth = (tick.p_WG - tick.p_WH).norm();
    m_forces.push_back(force);
    m_sum.peakForce_N = std::max(m_sum.peakForce_N, force);
    m_sum.peakDepth_mm = std::max(m_sum.peakDepth_mm, depth);
    auto found = m_sum.structures.find(structure);
    if (found == m_sum.structures.end()) {
        found = m_sum.structures.emplace(structure, StructureMeasures{}).first;
    }
    StructureMeasures& part = found->second;
    part.contactTime_s += 1.0; // ticks until `result`
    part.meanForce_N += force; // sum until `result`
    part.peakForce_N = std::max(part.peakForce_N, force);
    part.peakDepth_mm = std::max(part.peakDepth_mm, depth);
}

Measures MeasureAccumulator::result() const
{
    Measures measures = m_sum;
    measures.contactTicks = static_cast<std::int64_t>(m_forces.size());
    measures.duration_s = static_cast<double>(measures.ticks) * m_dt_s;
    measures.contactTime_s = static_cast<double>(measures.contactTicks) * m_dt_s;
    for (auto& [name, part] : measures.structures) {
        part.meanForce_N /= part.contactTime_s;
        part.contactTime_s *= m_dt_s;
    }
    if (m_forces.empty()) {
        return measures;
    }
    double sum = 0.0;
    for (const double force : m_forces) {
        sum += force;
    }
    measures.meanForce_N = sum / static_cast<double>(m_forces.size());
    std::vector<double> sorted = m_forces;
    const auto rank = static_cast<std::ptrdiff_t>(std::ceil(0.95 * static_cast<double>(sorted.size()))) - 1;
    std::nth_element(sorted.begin(), sorted.begin() + rank, sorted.end());
    measures.p95Force_N = sorted[static_cast<std::size_t>(rank)];
    return measures;
}

} // namespace palpate::session
