// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>
#include <palpate/meshio/SceneFile.h>
#include <palpate/session/MeasureSession.h>
#include <palpate/study/ExerciseReport.h>
#include <palpate/study/ExerciseScore.h>

#include <filesystem>

namespace palpate::app {

/// Score of an exercise with the facts for its page.
struct ScoredExercise
{
    study::ExerciseScore score;
    study::ExerciseFacts facts;
};

/// Scores a recording as `palpate session exercise` does, with the same distances.
/// @param meshes  surfaces of the open scene; others are loaded from the paths in the recording
/// @par Thread Any. Cost: as `session measure`.
[[nodiscard]] core::Result<ScoredExercise>
scoreRecording(const std::filesystem::path& recording, session::MeshesByHash meshes, const meshio::Exercise& exercise);

} // namespace palpate::app
