// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/Measures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace palpate::session {

namespace {

double mean(const std::vector<double>& values)
{
    return values.empty() ? 0.0
                          : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Nearest-rank percentile: the smallest value that is greater than or equal to at least this share of all values.
double percentile(std::vector<double> values, double share)
{
    if (values.empty()) {
        return 0.0;
    }
    const auto rank = std::max<std::ptrdiff_t>(
        static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(values.size()))) - 1, 0);
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return values[static_cast<std::size_t>(rank)];
}

} // namespace

bool follows(const std::optional<servo::TickRecord>& before, const servo::TickRecord& now) noexcept
{
    constexpr int kStartsAnew = servo::kNoHand | servo::kReset | servo::kDroppedBefore;
    return before && before->tick + 1 == now.tick && (now.flags & kStartsAnew) == 0 &&
           (before->flags & servo::kNoHand) == 0;
}

MeasureAccumulator::MeasureAccumulator(double dt_s)
    : m_dt_s(dt_s)
{
}

/// @param goesOn  continues from the previous tick
void MeasureAccumulator::Samples::add(std::int64_t tick, bool goesOn, double force_N, double depth_mm)
{
    contacts += goesOn && last && *last + 1 >= tick ? 0 : 1;
    last = tick;
    forces_N.push_back(force_N);
    depths_mm.push_back(depth_mm);
}

void MeasureAccumulator::add(const servo::TickRecord& tick, const StructureNames& names)
{
    ++m_sum.ticks;
    const bool goesOn = follows(m_previous, tick);
    if (goesOn) {
        m_sum.pathLength_mm += (tick.p_WH - m_previous->p_WH).norm();
        if (tick.felt.structure >= 0 && m_previous->felt.structure >= 0) {
            m_sum.contactPath_mm += (tick.felt.p_WG - m_previous->felt.p_WG).norm();
        }
    }
    if (tick.felt.structure >= 0) {
        m_all.add(tick.tick, goesOn, tick.felt.f_W.norm(), (tick.felt.p_WG - tick.p_WH).norm());
    }
    for (std::size_t i = 0; i < tick.felt.contactCount; ++i) {
        const haptics::Contact& contact = tick.felt.contacts[i];
        const std::string_view name = names(contact.structure);
        auto found = m_structures.find(name);
        if (found == m_structures.end()) {
            found = m_structures.emplace(name, Samples{}).first;
        }
        found->second.add(tick.tick, goesOn, contact.f_W.norm(), contact.depth_mm);
    }
    m_previous = tick;
}

ContactMeasures MeasureAccumulator::summary(const Samples& samples) const
{
    ContactMeasures out;
    out.ticks = static_cast<std::int64_t>(samples.forces_N.size());
    out.contacts = samples.contacts;
    out.time_s = static_cast<double>(out.ticks) * m_dt_s;
    out.peakForce_N = percentile(samples.forces_N, 1.0);
    out.meanForce_N = mean(samples.forces_N);
    out.medianForce_N = percentile(samples.forces_N, 0.5);
    out.p95Force_N = percentile(samples.forces_N, 0.95);
    out.peakDepth_mm = percentile(samples.depths_mm, 1.0);
    out.meanDepth_mm = mean(samples.depths_mm);
    out.p95Depth_mm = percentile(samples.depths_mm, 0.95);
    return out;
}

Measures MeasureAccumulator::result() const
{
    Measures measures = m_sum;
    measures.duration_s = static_cast<double>(measures.ticks) * m_dt_s;
    measures.contact = summary(m_all);
    for (const auto& [name, samples] : m_structures) {
        measures.structures.emplace(name, summary(samples));
    }
    return measures;
}

} // namespace palpate::session
