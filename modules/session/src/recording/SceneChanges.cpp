// SPDX-License-Identifier: BSD-3-Clause
#include "recording/SceneChanges.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace palpate::session::internal {

namespace {

RecordingEvent event(std::int64_t tick, const char* kind, const QJsonObject& json)
{
    return {tick, kind, QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString()};
}

/// Returns a number before and after a change.
QJsonArray change(double before, double after)
{
    return {before, after};
}

bool isSameList(const SceneRecord& a, const SceneRecord& b)
{
    return std::equal(a.structures.begin(), a.structures.end(), b.structures.begin(), b.structures.end(),
                      [](const StructureRecord& x, const StructureRecord& y) {
                          return x.name == y.name && x.source.mesh == y.source.mesh && x.source.part == y.source.part;
                      });
}

} // namespace

std::vector<RecordingEvent> sceneChanges(std::int64_t tick, const SceneRecord& before, const SceneRecord& after)
{
    std::vector<RecordingEvent> events;
    if (!isSameList(before, after)) {
        events.push_back(event(tick, "structures",
                               {{"count", change(static_cast<double>(before.structures.size()),
                                                 static_cast<double>(after.structures.size()))}}));
        return events;
    }
    for (std::size_t i = 0; i < after.structures.size(); ++i) {
        const StructureRecord& was = before.structures[i];
        const StructureRecord& is = after.structures[i];
        const QJsonObject which{{"structure", QString::fromStdString(is.name)}};
        if (was.palpable != is.palpable) {
            events.push_back(event(tick, is.palpable ? "shown" : "hidden", which));
        }
        if (was.tissue != is.tissue) {
            QJsonObject json = which;
            for (const core::TissueTerm& term : core::kTissueTerms) {
                json[term.key.data()] = change(was.tissue.*term.member, is.tissue.*term.member);
            }
            events.push_back(event(tick, "tissue", json));
        }
        const bool isSameMotion =
            was.motion == is.motion || (was.motion != nullptr && is.motion != nullptr && *was.motion == *is.motion);
        if (!isSameMotion) {
            QJsonObject json = which;
            json["moves"] = is.motion != nullptr;
            if (is.motion != nullptr) {
                json["rate"] = is.motion->pace().rate;
                json["amplitude"] = is.motion->pace().amplitude;
            }
            events.push_back(event(tick, "motion", json));
        }
        if (was.layer != is.layer) {
            QJsonObject json = which;
            json["layer"] = change(was.layer, is.layer);
            events.push_back(event(tick, "layer", json));
        }
    }
    return events;
}

} // namespace palpate::session::internal
