// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuresReport.h"

#include "Console.h"

#include <QJsonArray>
#include <QJsonDocument>

namespace palpate::app {

namespace {

QString text(const std::string& value)
{
    return QString::fromStdString(value);
}

QJsonObject contactJson(const session::ContactMeasures& m)
{
    return {{"contact_ticks", static_cast<qint64>(m.ticks)},
            {"contact_time_s", m.time_s},
            {"peak_force_N", m.peakForce_N},
            {"mean_force_N", m.meanForce_N},
            {"median_force_N", m.medianForce_N},
            {"p95_force_N", m.p95Force_N},
            {"peak_depth_mm", m.peakDepth_mm},
            {"mean_depth_mm", m.meanDepth_mm},
            {"p95_depth_mm", m.p95Depth_mm}};
}

const char* nameOf(session::Phase::Kind kind)
{
    return kind == session::Phase::Kind::Search ? "search" : "press";
}

QJsonObject phasesJson(const std::vector<session::Phase>& phases)
{
    QJsonObject out;
    QJsonArray list;
    for (const auto kind : {session::Phase::Kind::Search, session::Phase::Kind::Press}) {
        const session::PhaseSummary sum = session::summary(phases, kind);
        out[nameOf(kind)] = QJsonObject{{"phases", static_cast<qint64>(sum.phases)},
                                        {"time_s", sum.time_s},
                                        {"mean_force_N", sum.meanForce_N},
                                        {"peak_force_N", sum.peakForce_N}};
    }
    for (const session::Phase& phase : phases) {
        list.append(QJsonObject{{"kind", nameOf(phase.kind)},
                                {"start_s", phase.start_s},
                                {"time_s", phase.time_s},
                                {"mean_force_N", phase.meanForce_N},
                                {"peak_force_N", phase.peakForce_N}});
    }
    out["list"] = list;
    return out;
}

QJsonArray findingsJson(const std::vector<session::FindingMeasures>& findings)
{
    QJsonArray out;
    for (const session::FindingMeasures& m : findings) {
        QJsonObject one{{"name", text(m.finding.name)},
                        {"structure", text(m.finding.structure)},
                        {"position_mm", QJsonArray{m.finding.p_W.x(), m.finding.p_W.y(), m.finding.p_W.z()}},
                        {"marked_s", m.marked_s},
                        {"force_when_marked_N", m.finding.force_N},
                        {"depth_when_marked_mm", m.finding.depth_mm},
                        {"dwell_s", m.dwell_s},
                        {"visits", static_cast<qint64>(m.visits)},
                        {"mean_force_N", m.meanForce_N},
                        {"peak_force_N", m.peakForce_N},
                        {"peak_depth_mm", m.peakDepth_mm}};
        one["first_touched_s"] = m.firstTouched_s ? QJsonValue(*m.firstTouched_s) : QJsonValue();
        out.append(one);
    }
    return out;
}

} // namespace

QJsonObject sumsJson(const session::Measures& m)
{
    QJsonObject structures;
    for (const auto& [name, part] : m.structures) {
        structures[text(name)] = contactJson(part);
    }
    QJsonObject out = contactJson(m.contact);
    out["ticks"] = static_cast<qint64>(m.ticks);
    out["duration_s"] = m.duration_s;
    out["path_length_mm"] = m.pathLength_mm;
    out["contact_path_mm"] = m.contactPath_mm;
    out["contacts"] = static_cast<qint64>(m.contacts);
    out["structures"] = structures;
    return out;
}

std::string measuresJson(const session::SessionMeasures& m)
{
    QJsonObject out = sumsJson(m.sums);
    QJsonObject structures = out["structures"].toObject();
    for (const session::SurfaceMeasures& surface : m.surfaces) {
        QJsonObject one = structures[text(surface.structure)].toObject();
        one["area_mm2"] = surface.area_mm2;
        one["covered_area_mm2"] = surface.coveredArea_mm2;
        one["coverage"] = surface.coverage();
        one["longest_dwell_s"] = surface.longestDwell_s;
        structures[text(surface.structure)] = one;
    }
    out["structures"] = structures;
    out["coverage_distance_mm"] = m.distance_mm;
    out["phases"] = phasesJson(m.phases);
    out["findings"] = findingsJson(m.findings);
    return QJsonDocument(out).toJson().toStdString();
}

void printMeasures(const session::SessionMeasures& m)
{
    const session::ContactMeasures& all = m.sums.contact;
    print("duration %.3f s, contact %.3f s in %s contact%s\n", m.sums.duration_s, all.time_s,
          grouped(m.sums.contacts).c_str(), m.sums.contacts == 1 ? "" : "s");
    print("path of the hand %.4g mm, on the surface %.4g mm\n", m.sums.pathLength_mm, m.sums.contactPath_mm);
    print("force in contact: peak %.4g N, mean %.4g N, median %.4g N, 95th percentile %.4g N\n", all.peakForce_N,
          all.meanForce_N, all.medianForce_N, all.p95Force_N);
    print("depth in contact: peak %.4g mm, mean %.4g mm, 95th percentile %.4g mm\n", all.peakDepth_mm, all.meanDepth_mm,
          all.p95Depth_mm);
    for (const auto kind : {session::Phase::Kind::Search, session::Phase::Kind::Press}) {
        const session::PhaseSummary sum = session::summary(m.phases, kind);
        print("%s: %.3f s in %lld phases, force mean %.4g N, peak %.4g N\n", nameOf(kind), sum.time_s,
              static_cast<long long>(sum.phases), sum.meanForce_N, sum.peakForce_N);
    }
    for (const auto& [name, part] : m.sums.structures) {
        print("  %s: contact %.3f s, force peak %.4g N, mean %.4g N, 95th percentile %.4g N, peak depth %.4g mm\n",
              name.c_str(), part.time_s, part.peakForce_N, part.meanForce_N, part.p95Force_N, part.peakDepth_mm);
    }
    for (const session::SurfaceMeasures& surface : m.surfaces) {
        print("  %s: %.3g %% of %.4g cm² covered (within %.3g mm), longest dwell at a point %.3f s\n",
              surface.structure.c_str(), 100.0 * surface.coverage(), 0.01 * surface.area_mm2, m.distance_mm,
              surface.longestDwell_s);
    }
    for (const session::FindingMeasures& one : m.findings) {
        print("  finding \"%s\" at (%.1f %.1f %.1f), marked at %.1f s: dwell %.3f s in %lld visits, force mean %.4g N, "
              "peak %.4g N\n",
              one.finding.name.c_str(), one.finding.p_W.x(), one.finding.p_W.y(), one.finding.p_W.z(), one.marked_s,
              one.dwell_s, static_cast<long long>(one.visits), one.meanForce_N, one.peakForce_N);
    }
}

} // namespace palpate::app
