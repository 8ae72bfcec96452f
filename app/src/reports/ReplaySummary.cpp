// SPDX-License-Identifier: BSD-3-Clause
#include "reports/ReplaySummary.h"

#include "shared/Console.h"
#include "shared/QtText.h"

#include <palpate/session/Recording.h>
#include <palpate/study/SessionExport.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate::app {

namespace {

/// Quantile of ascending values by nearest rank.
std::uint32_t atShare(const std::vector<std::uint32_t>& sorted, double share)
{
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
    return sorted[std::clamp<std::size_t>(rank, 1, sorted.size()) - 1];
}

double perTriangle(const SceneCost& cost)
{
    return cost.triangles == 0 ? 0.0 : static_cast<double>(cost.bytes) / static_cast<double>(cost.triangles);
}

} // namespace

ReplaySummary::ReplaySummary(SceneCost cost, double dt_s)
    : m_cost(std::move(cost))
    , m_measures(dt_s)
{
}

void ReplaySummary::reserve(std::size_t ticks)
{
    m_solve_ns.reserve(ticks);
}

void ReplaySummary::add(const servo::TickRecord& tick, const session::StructureNames& names)
{
    m_measures.add(tick, names);
    m_solve_ns.push_back(tick.solve_ns);
    m_mostIterations = std::max(m_mostIterations, tick.felt.iterations);
    m_iterationBounds += (tick.flags & servo::kIterationLimit) != 0 ? 1 : 0;
    m_gated += (tick.flags & servo::kInputGated) != 0 ? 1 : 0;
}

SolveTimes ReplaySummary::solveTimes() const
{
    SolveTimes times;
    if (m_solve_ns.empty()) {
        return times;
    }
    std::vector<std::uint32_t> sorted = m_solve_ns;
    std::sort(sorted.begin(), sorted.end());
    times.p50 = atShare(sorted, 0.5);
    times.p99 = atShare(sorted, 0.99);
    times.p999 = atShare(sorted, 0.999);
    times.max = sorted.back();
    for (const std::uint32_t t : sorted) {
        times.mean += t / static_cast<double>(sorted.size());
    }
    return times;
}

void ReplaySummary::print() const
{
    const session::Measures m = m_measures.result();
    const SolveTimes t = solveTimes();
    app::print("%s: %zu structure%s, %s triangles; ready to touch in %.3f s (index %.3f s), %.1f bytes a triangle\n",
               m_cost.name.c_str(), m_cost.structures, m_cost.structures == 1 ? "" : "s",
               grouped(m_cost.triangles).c_str(), m_cost.load_s + m_cost.index_s, m_cost.index_s, perTriangle(m_cost));
    for (const std::string& line : m_lumpLines) {
        app::print("lump: %s\n", line.c_str());
    }
    app::print("ticks %s (%.3f s), in contact %s\n", grouped(m.ticks).c_str(), m.duration_s,
               grouped(m.contact.ticks).c_str());
    app::print("peak force %.4g N, mean in contact %.4g N, peak depth %.4g mm\n", m.contact.peakForce_N,
               m.contact.meanForce_N, m.contact.peakDepth_mm);
    app::print("solver p50 %u ns, p99 %u ns, p99.9 %u ns, max %u ns; iteration bound hit %lld times\n", t.p50, t.p99,
               t.p999, t.max, static_cast<long long>(m_iterationBounds));
    if (m_lost) {
        app::print("live: %lld ticks lost, %llu overruns, safety gate changed the HIP %lld times\n",
                   static_cast<long long>(*m_lost), static_cast<unsigned long long>(m_overruns),
                   static_cast<long long>(m_gated));
    }
}

std::string ReplaySummary::json() const
{
    const session::Measures m = m_measures.result();
    const SolveTimes t = solveTimes();
    QJsonObject root = study::sumsJson(m);
    root["palpate"] = text(session::palpateVersion());
    root["build"] = text(session::buildId());
    root["scene"] = QJsonObject{{"name", text(m_cost.name)},
                                {"structures", static_cast<qint64>(m_cost.structures)},
                                {"triangles", static_cast<qint64>(m_cost.triangles)},
                                {"bytes", static_cast<qint64>(m_cost.bytes)},
                                {"bytes_per_triangle", perTriangle(m_cost)},
                                {"load_s", m_cost.load_s},
                                {"index_s", m_cost.index_s},
                                {"ready_to_touch_s", m_cost.load_s + m_cost.index_s}};
    QJsonArray notes;
    for (const core::Message& note : m_cost.notes) {
        notes.append(text(note.english()));
    }
    root["notes"] = notes;
    root["solve_ns"] = QJsonObject{{"p50", static_cast<qint64>(t.p50)},
                                   {"p99", static_cast<qint64>(t.p99)},
                                   {"p99.9", static_cast<qint64>(t.p999)},
                                   {"max", static_cast<qint64>(t.max)},
                                   {"mean", t.mean}};
    root["lumps"] = m_lumps;
    root["iteration_bound_hits"] = static_cast<qint64>(m_iterationBounds);
    root["most_iterations"] = static_cast<qint64>(m_mostIterations);
    if (m_lost) {
        root["live"] = QJsonObject{{"lost_ticks", static_cast<qint64>(*m_lost)},
                                   {"overruns", static_cast<qint64>(m_overruns)},
                                   {"gated_ticks", static_cast<qint64>(m_gated)}};
    }
    if (m_resimulation) {
        QJsonObject result{{"compared_ticks", static_cast<qint64>(m_resimulation->compared)},
                           {"unverified_ticks", static_cast<qint64>(m_resimulation->unverified)},
                           {"identical", m_resimulation->isSame()},
                           {"within_rounding", m_resimulation->isWithinRounding()},
                           {"rounding_mm", m_resimulation->rounding_mm}};
        if (m_resimulation->firstDifference) {
            result["differing_ticks"] = static_cast<qint64>(m_resimulation->differing);
            result["first_difference"] = static_cast<qint64>(*m_resimulation->firstDifference);
            result["difference"] = text(m_resimulation->difference.english());
            result["farthest_mm"] = m_resimulation->farthest_mm;
            result["farthest_N"] = m_resimulation->farthest_N;
        }
        if (m_resimulation->firstBeyond) {
            result["first_beyond_rounding"] = static_cast<qint64>(*m_resimulation->firstBeyond);
            result["beyond_rounding"] = text(m_resimulation->beyond.english());
        }
        root["resimulation"] = result;
    }
    return QJsonDocument(root).toJson().toStdString();
}

} // namespace palpate::app
