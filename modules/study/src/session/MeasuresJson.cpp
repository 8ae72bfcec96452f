// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/FindingsFile.h"
#include "palpate/study/SessionExport.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <optional>

namespace palpate::study {

namespace {

QString text(const std::string& value)
{
    return QString::fromStdString(value);
}

QJsonValue orNull(const std::optional<double>& value)
{
    return value ? QJsonValue(*value) : QJsonValue();
}

QJsonObject contactJson(const session::ContactMeasures& m)
{
    return {{"contact_ticks", static_cast<qint64>(m.ticks)},
            {"contacts", static_cast<qint64>(m.contacts)},
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

QJsonObject phaseJson(const session::PhaseSummary& sum)
{
    return {{"phases", static_cast<qint64>(sum.phases)},
            {"time_s", sum.time_s},
            {"mean_force_N", sum.meanForce_N},
            {"peak_force_N", sum.peakForce_N}};
}

QJsonObject phasesJson(const std::vector<session::Phase>& phases)
{
    QJsonObject out;
    QJsonArray list;
    for (const auto kind : {session::Phase::Kind::Search, session::Phase::Kind::Press}) {
        out[nameOf(kind)] = phaseJson(session::summary(phases, kind));
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
        if (!m.finding.hasPlace) {
            continue;
        }
        QJsonObject one{{"id", text(m.finding.id)},
                        {"type", text(std::string(core::nameOf(m.finding.type)))},
                        {"note", text(m.finding.note)},
                        {"size_mm", orNull(m.finding.size_mm)},
                        {"name", text(m.finding.name)},
                        {"structure", text(m.finding.structure)},
                        {"inside", text(organOf(m.finding))},
                        {"position_mm", QJsonArray{m.finding.p_W.x(), m.finding.p_W.y(), m.finding.p_W.z()}},
                        {"marked_s", m.marked_s},
                        {"force_when_marked_N", orNull(m.finding.force_N)},
                        {"depth_when_marked_mm", orNull(m.finding.depth_mm)},
                        {"dwell_s", m.dwell_s},
                        {"visits", static_cast<qint64>(m.visits)},
                        {"mean_force_N", m.meanForce_N},
                        {"peak_force_N", m.peakForce_N},
                        {"peak_depth_mm", m.peakDepth_mm}};
        one["first_touched_s"] = orNull(m.firstTouched_s);
        QJsonArray layers;
        for (const core::FindingLayer& layer : m.finding.layers) {
            layers.append(QJsonObject{
                {"structure", text(layer.structure)}, {"force_N", layer.force_N}, {"depth_mm", layer.depth_mm}});
        }
        one["layers_when_marked"] = layers;
        out.append(one);
    }
    return out;
}

QJsonArray notesJson(const std::vector<session::FindingMeasures>& findings)
{
    QJsonArray out;
    for (const session::FindingMeasures& m : findings) {
        if (!m.finding.hasPlace) {
            out.append(
                QJsonObject{{"name", text(m.finding.name)}, {"note", text(m.finding.note)}, {"marked_s", m.marked_s}});
        }
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
    out["structures"] = structures;
    return out;
}

QJsonArray lumpsJson(const std::vector<session::LumpSearch>& lumps)
{
    QJsonArray out;
    for (const session::LumpSearch& one : lumps) {
        out.append(QJsonObject{{"name", text(one.lump)},
                               {"organ", text(one.organ)},
                               {"told_area_mm2", one.detectable_mm2},
                               {"pressed_area_mm2", one.pressed_mm2},
                               {"pressed_hard_enough", orNull(one.share())},
                               {"greatest_change_percent", orNull(one.recorded_percent)},
                               {"predicted_change_percent", orNull(one.predicted_percent)}});
    }
    return out;
}

QJsonObject measuresObject(const session::SessionMeasures& m)
{
    QJsonObject out = sumsJson(m.sums);
    QJsonObject structures = out["structures"].toObject();
    for (const auto& [name, phases] : m.structurePhases) {
        QJsonObject one = structures[text(name)].toObject();
        for (const auto kind : {session::Phase::Kind::Search, session::Phase::Kind::Press}) {
            one[nameOf(kind)] = phaseJson(session::summary(phases, kind));
        }
        structures[text(name)] = one;
    }
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
    QJsonArray damaged;
    for (const core::Message& fault : m.damaged) {
        damaged.append(text(fault.english()));
    }
    out["damaged"] = damaged;
    out["lost_ticks"] = static_cast<qint64>(m.lostTicks);
    out["late_ticks"] = m.lateTicks ? QJsonValue(static_cast<qint64>(*m.lateTicks)) : QJsonValue();
    out["phases"] = phasesJson(m.phases);
    out["findings"] = findingsJson(m.findings);
    out["lumps"] = lumpsJson(m.lumps);
    out["notes"] = notesJson(m.findings);
    return out;
}

std::string measuresJson(const session::SessionMeasures& m)
{
    return QJsonDocument(measuresObject(m)).toJson().toStdString();
}

} // namespace palpate::study
