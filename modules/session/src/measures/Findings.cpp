// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/Findings.h"

#include "palpate/session/Measures.h"
#include "palpate/session/TouchPlace.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <iterator>
#include <map>

namespace palpate::session {

namespace {

std::optional<double> numberIn(const QJsonObject& json, const char* key)
{
    const QJsonValue value = json[QLatin1String(key)];
    return value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
}

std::optional<core::Vec3> pointIn(const QJsonValue& value)
{
    const QJsonArray list = value.toArray();
    if (list.size() != 3 || !list[0].isDouble() || !list[1].isDouble() || !list[2].isDouble()) {
        return std::nullopt;
    }
    return core::Vec3(list[0].toDouble(), list[1].toDouble(), list[2].toDouble());
}

std::optional<core::ViewPose> viewIn(const QJsonObject& json)
{
    const auto position = pointIn(json["position"]);
    const auto focus = pointIn(json["focus"]);
    const auto up = pointIn(json["up"]);
    if (!position || !focus || !up) {
        return std::nullopt;
    }
    return core::ViewPose{*position, *focus, *up, json["viewAngle_deg"].toDouble(30.0)};
}

QJsonArray list(const core::Vec3& v)
{
    return {v.x(), v.y(), v.z()};
}

/// Returns the finding of an event; empty if there is none.
std::optional<core::Finding> findingIn(const RecordingEvent& event)
{
    QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(event.json)).object();
    if (event.kind == "note" && !json.contains("text")) {
        return std::nullopt;
    }
    if (event.kind == "note" && !json.contains("note")) { // older recordings contain only the text
        json["note"] = json.value("text");
        json["name"] = "Note";
    }
    auto finding = findingFrom(json);
    const bool mayLackPlace = event.kind != "finding" || !finding.id.empty();
    return finding.hasPlace || mayLackPlace ? std::optional(std::move(finding)) : std::nullopt;
}

} // namespace

core::Finding findingFrom(const QJsonObject& json)
{
    core::Finding finding;
    const auto text = [&](const char* key) { return json[QLatin1String(key)].toString().toStdString(); };
    finding.id = text("id");
    finding.name = text("name");
    finding.type = core::findingType(text("type")).value_or(core::FindingType::Other);
    const auto place = pointIn(json["position"]);
    finding.hasPlace = place.has_value();
    finding.p_W = place.value_or(finding.p_W);
    finding.note = text("note");
    finding.structure = text("structure");
    finding.size_mm = numberIn(json, "size_mm");
    finding.force_N = numberIn(json, "force_N");
    finding.depth_mm = numberIn(json, "depth_mm");
    for (const QJsonValue& value : json["layers"].toArray()) {
        const QJsonObject layer = value.toObject();
        finding.layers.push_back(
            {layer["structure"].toString().toStdString(), layer["force_N"].toDouble(), layer["depth_mm"].toDouble()});
    }
    finding.camera = viewIn(json["camera"].toObject());
    finding.marked_utc = text("marked_utc");
    return finding;
}

QJsonObject toJson(const core::Finding& finding)
{
    QJsonObject json{{"name", QString::fromStdString(finding.name)},
                     {"structure", QString::fromStdString(finding.structure)}};
    const auto putText = [&](const char* key, const std::string& value) {
        if (!value.empty()) {
            json[QLatin1String(key)] = QString::fromStdString(value);
        }
    };
    const auto putNumber = [&](const char* key, const std::optional<double>& value) {
        if (value) {
            json[QLatin1String(key)] = *value;
        }
    };
    putText("id", finding.id);
    if (finding.type != core::FindingType::Other) {
        putText("type", std::string(core::nameOf(finding.type)));
    }
    if (finding.hasPlace) {
        json["position"] = list(finding.p_W);
    }
    putNumber("size_mm", finding.size_mm);
    putNumber("force_N", finding.force_N);
    putNumber("depth_mm", finding.depth_mm);
    if (!finding.layers.empty()) {
        QJsonArray layers;
        for (const core::FindingLayer& layer : finding.layers) {
            layers.append(QJsonObject{{"structure", QString::fromStdString(layer.structure)},
                                      {"force_N", layer.force_N},
                                      {"depth_mm", layer.depth_mm}});
        }
        json["layers"] = layers;
    }
    putText("note", finding.note);
    if (finding.camera) {
        json["camera"] = QJsonObject{{"position", list(finding.camera->position_W)},
                                     {"focus", list(finding.camera->focus_W)},
                                     {"up", list(finding.camera->up_W)},
                                     {"viewAngle_deg", finding.camera->viewAngle_deg}};
    }
    putText("marked_utc", finding.marked_utc);
    return json;
}

std::string findingJson(const core::Finding& finding)
{
    QJsonObject json = toJson(finding);
    if (!finding.hasPlace) {
        json["text"] = QString::fromStdString(finding.note); // key used by older versions
        json["note"] = json.value("text");
    }
    return QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString();
}

std::vector<std::pair<std::int64_t, core::Finding>> findingsOf(const std::vector<RecordingEvent>& events)
{
    using Marked = std::pair<std::int64_t, core::Finding>;
    std::vector<Marked> findings;
    std::map<std::string, std::int64_t> firstTicks; // by id: restored findings keep the original time of marking
    const auto newest = [&](const core::Finding& finding) {
        return std::find_if(findings.rbegin(), findings.rend(), [&](const Marked& one) {
            return finding.id.empty() ? one.second.name == finding.name : one.second.id == finding.id;
        });
    };
    for (const RecordingEvent& event : events) {
        const bool isUndone = event.kind == "finding-undone";
        const bool isEdited = event.kind == "finding-edited";
        const bool isNew = event.kind == "finding" || event.kind == "note";
        auto finding = isUndone || isEdited || isNew ? findingIn(event) : std::nullopt;
        if (!finding) {
            continue;
        }
        if (isNew) {
            const std::int64_t tick =
                finding->id.empty() ? event.tick : firstTicks.emplace(finding->id, event.tick).first->second;
            findings.emplace_back(tick, std::move(*finding));
            continue;
        }
        const auto old = newest(*finding);
        if (old != findings.rend() && isEdited) {
            old->second = std::move(*finding);
        } else if (old != findings.rend()) {
            findings.erase(std::next(old).base());
        }
    }
    std::stable_sort(findings.begin(), findings.end(),
                     [](const Marked& a, const Marked& b) { return a.first < b.first; });
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
        if (!m.finding.hasPlace) {
            continue;
        }
        for (std::size_t i = 0; i < tick.felt.contactCount; ++i) {
            const haptics::Contact& contact = tick.felt.contacts[i];
            if (TouchPlace(tick.felt, contact).reaches(m.finding.p_W, m_distance_mm)) {
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
