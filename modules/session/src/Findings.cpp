// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/Findings.h"

#include "palpate/session/Measures.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace palpate::session {

std::string findingJson(const Finding& finding)
{
    const QJsonObject json{{"name", QString::fromStdString(finding.name)},
                           {"structure", QString::fromStdString(finding.structure)},
                           {"position", QJsonArray{finding.p_W.x(), finding.p_W.y(), finding.p_W.z()}},
                           {"force_N", finding.force_N},
                           {"depth_mm", finding.depth_mm}};
    return QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString();
}

std::optional<Finding> findingOf(const RecordingEvent& event)
{
    const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(event.json)).object();
    const QJsonArray position = json["position"].toArray();
    if (event.kind != "finding" || position.size() != 3) {
        return std::nullopt;
    }
    Finding finding;
    finding.name = json["name"].toString().toStdString();
    finding.structure = json["structure"].toString().toStdString();
    finding.p_W = {position[0].toDouble(), position[1].toDouble(), position[2].toDouble()};
    finding.force_N = json["force_N"].toDouble();
    finding.depth_mm = json["depth_mm"].toDouble();
    return finding;
}

FindingAccumulator::FindingAccumulator(const std::vector<RecordingEvent>& events, std::int64_t firstTick, double dt_s,
                                       double distance_mm)
    : m_firstTick(firstTick)
    , m_dt_s(dt_s)
    , m_distance_mm(distance_mm)
{
    for (const RecordingEvent& event : events) {
        if (auto finding = findingOf(event)) {
            Sum& sum = m_sums.emplace_back();
            sum.measures.finding = std::move(*finding);
            sum.measures.marked_s = static_cast<double>(event.tick - firstTick) * dt_s;
        }
    }
}

void FindingAccumulator::add(const servo::TickRecord& tick)
{
    const bool goesOn = follows(m_previous, tick);
    m_previous = tick;
    for (Sum& sum : m_sums) {
        FindingMeasures& m = sum.measures;
        const bool wasThere = sum.isThere && goesOn;
        sum.isThere = tick.felt.structure >= 0 && (tick.felt.p_WG - m.finding.p_W).norm() <= m_distance_mm;
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
        m.peakDepth_mm = std::max(m.peakDepth_mm, (tick.felt.p_WG - tick.p_WH).norm());
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
