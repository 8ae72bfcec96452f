// SPDX-License-Identifier: BSD-3-Clause
#include "exercise/ExerciseRun.h"

#include <palpate/session/RecordingReader.h>
#include <palpate/study/RecordedScene.h>

#include <algorithm>
#include <utility>

namespace palpate::app {

core::Result<ScoredExercise> scoreRecording(const std::filesystem::path& recording, session::MeshesByHash meshes,
                                            const meshio::Exercise& exercise)
{
    const auto opened = session::RecordingReader::open(recording);
    if (!opened.isOk()) {
        return opened.status();
    }
    const session::RecordingReader& reader = *opened.value();
    const auto& scenes = reader.scenes();
    const bool isAnyMissing = std::any_of(scenes.begin(), scenes.end(), [&meshes](const session::SceneRecord& scene) {
        return std::any_of(scene.structures.begin(), scene.structures.end(),
                           [&meshes](const session::StructureRecord& one) {
                               return !one.source.sha256.empty() && !meshes.contains(one.source.sha256);
                           });
    });
    if (isAnyMissing) {
        if (auto found = study::recordedSurfaces(reader); found.isOk()) {
            meshes.merge(found.value());
        }
    }
    study::ExerciseOptions how;
    how.coverageDistance_mm = study::defaultDistance_mm(reader, meshes);
    auto score = study::scoreExercise(reader, meshes, exercise, how);
    if (!score.isOk()) {
        return score.status();
    }
    ScoredExercise out{std::move(score).value(), {}};
    out.facts.recording = recording.filename().string();
    out.facts.startedUtc = reader.info().startedUtc;
    return out;
}

} // namespace palpate::app
