// SPDX-License-Identifier: BSD-3-Clause
#include "recording/RecordingSurvey.h"

#include "store/MapRows.h"

#include <utility>

namespace palpate::session::internal {

Survey survey(const RecordingTables& tables, const MetaTable& meta, const std::function<bool(double)>& progress)
{
    Survey result;
    const auto note = [&result](const core::Status& status) {
        if (!status.isOk()) {
            result.faults.push_back(status.text());
        }
    };
    std::vector<SceneRecord> scenes;
    Events events;
    note(tables.readScenes(scenes));
    note(tables.readEvents(events));
    for (const SceneRecord& scene : scenes) {
        for (const StructureRecord& structure : scene.structures) {
            if (mapsText({structure.tissueMaps, structure.motion}) != structure.maps) {
                result.faults.push_back(
                    {PALPATE_TEXT("structure \"%1\": a map of its tissue or its motion is not there, or damaged"),
                     oneLine(structure.name)});
            }
        }
    }
    CheckedLines lines(tables, meta, scenes, events);
    note(lines.read());
    constexpr std::size_t kAsk = 64; // blocks between two calls of the progress
    for (std::size_t i = 0; i < lines.blocks().size(); ++i) {
        if (i % kAsk == 0 && progress &&
            !progress(static_cast<double>(i) / static_cast<double>(lines.blocks().size()))) {
            return result;
        }
        if (lines.block(i)->isIntact) {
            result.blocks.push_back(lines.blocks()[i]);
        }
    }
    result.known = lines.known();
    result.covered = lines.covered();
    result.faults.insert(result.faults.end(), lines.faults().begin(), lines.faults().end());
    for (const std::string& hash : tables.embeddedHashes()) {
        const auto read = tables.readEmbedded(hash);
        if (read.isOk()) {
            result.embedded.push_back(hash);
        }
        note(read.status());
    }
    return result;
}

} // namespace palpate::session::internal
