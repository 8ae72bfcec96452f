// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/Findings.h"

#include "palpate/session/Measures.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <iterator>

namespace palpate::session {

namespace {

std::optional<double> numberIn(const QJsonObject& json, const char* key)
{
    const QJsonValue value = json[QLatin1String(key)];
    return value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
}

/// @return nothing without a position.
std::optional<core::Finding> findingIn(const std::string& text)
{
    const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
    const QJsonArray position = json["position"].toArray();
    if (position.size() != 3) {
        return std::nullopt;
    }
    core::Finding finding;
    finding.name = json["name"].toString().toStdString();
    finding.p_W = {position[0].toDouble(), position[1].toDouble(), position[2].toDouble()};
    finding.note = json["note"].toString().toStdString();
    finding.structure = json["structure"].toString().toStdString();
    finding.force_N = numberIn(json, "force_N");
    finding.depth_mm = numberIn(json, "depth_mm");
    for (const QJsonValue& value : json["layers"].toArray()) {
        const QJsonObject layer = value.toObject();
        finding.layers.push_back(
            {layer["structure"].toString().toStdString(), layer["force_N"].toDouble(), layer["depth_mm"].toDouble()});
    }
    return finding;
}

} // namespace

std::string findingJson(const core::Finding& finding)
{
    QJsonObject json{{"name", QString::fromStdString(finding.name)},
                     {"structure", QString::fromStdString(finding.structure)},
                     {"position", QJsonArray{finding.p_W.x(), finding.p_W.y(), finding.p_W.z()}}};
    if (finding.force_N) {
        json["force_N"] = *finding.force_N;
    }
    if (finding.depth_mm) {
        json["depth_mm"] = *finding.depth_mm;
    }
    if (!finding.layers.empty()) {
        QJsonArray layers;
        for (const core::FeltLayer& layer : finding.layers) {
            layers.append(QJsonObject{{"structure", QString::fromStdString(layer.structure)},
                                      {"force_N", layer.force_N},
                                      {"depth_mm", layer.depth_mm}});
        }
        json["layers"] = layers;
    }
    if (!finding.note.empty()) {
        json["note"] = QString::fromStdString(finding.note);
    }
    return QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString();
}

std::vector<std::pair<std::int64_t, core::Finding>> findingsOf(const std::vector<RecordingEvent>& events)
{
    std::vector<std::pair<std::int64_t, core::Finding>> findings;
    for (const RecordingEvent& event : events) {
        const bool isUndone = event.kind == "finding-undone";
        auto finding = isUndone || event.kind == "finding" ? findingIn(event.json) : std::nullopt;
        if (!finding) {
            continue;
        }
        if (!isUndone) {
            findings.emplace_back(event.tick, std::move(*finding));
            continue;
        }
        const auto newest = std::find_if(findings.rbegin(), findings.rend(),
                                         [&](const auto& one) { return one.second.name == finding->name; });
        if (newest != findings.rend()) {
            findings.erase(std::next(newest).base());
        }
    }
    return findings;
}

FindingAccumulator::FindingAccumulator(const std::vector<RecordingEvent>& events, std::int64_t firstTick, double dt_s,
                                       double distance_mm)
    : m_firstTick(firstTick)
    , m_dt_s(dt_s)
    , m_distance_mm(distance_mm)
{
    for (auto& [tick, finding] : findingsOf(events)) {
        Sum& sum = m_sums.emplace_back();
        sum.measures.finding = std::move(finding);
        sum.measures.marked_s = static_cast<double>(tick - firstTick) * dt_s;
    }
}

void FindingAccumulator::add(const servo::TickRecord& tick)
{
    const bool goesOn = follows(m_previous, tick);
    m_previous = tick;
    for (Sum& sum : m_sums) {
        FindingMeasures& m = sum.measures;
        const bool wasThere = sum.isThere && goesOn;
        double depth_mm = 0.0;
        sum.isThere = false;
        for (std::size_t i = 0; i < tick.felt.contactCount; ++i) {
            const haptics::Contact& contact = tick.felt.contacts[i];
            if ((contact.p_WG - m.finding.p_W).norm() <= m_distance_mm) {
                sum.isThere = true;
                depth_mm = std::max(depth_mm, contact.depth_mm);
            }
        }
        if (!sum.isThere) {
            continue;
        }
        if (!m.firstTouched_s) {
            m.firstTouched_s = static_cast<double>(tick.tick - m_firstTick) * m_dt_s;
        }
        m.visits += wasThere ? 0 : 1;
        ++sum.ticks;
        sum.force_N += tick.felt.f_W.norm();
        m.peakForce_N = std::max(m.peakForce_N, tick.felt.f_W.norm());
        m.peakDepth_mm = std::max(m.peakDepth_mm, depth_mm);
    }
}

std::vector<FindingMeasures> FindingAccumulator::result() const
{
    std::vector<FindingMeasures> out;
    for (const Sum& sum : m_sums) {
        FindingMeasures& m = out.emplace_back(sum.measures);
        m.dwell_s = static_cast<double>(sum.ticks) * m_dt_s;
        m.meanForce_N = sum.ticks > 0 ? sum.force_N / static_cast<double>(sum.ticks) : 0.0;
    }
    return out;
}

} // namespace palpate::session
