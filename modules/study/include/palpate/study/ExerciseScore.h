// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Finding.h>
#include <palpate/core/Status.h>
#include <palpate/geometry/TriangleMesh.h>
#include <palpate/meshio/SceneFile.h>
#include <palpate/session/MeasureSession.h>
#include <palpate/session/RecordingReader.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace palpate::study {

/// Ball around a target of an exercise: the area-weighted centroid of its surface and the largest distance of a vertex
/// from there.
struct TargetBall
{
    core::Vec3 centre_W = core::Vec3::Zero(); ///< [mm]
    double radius_mm = 0.0;
};
/// @param mesh  in W [mm], with at least one triangle of nonzero area
[[nodiscard]] PALPATE_EXPORT TargetBall ballAround(const geometry::TriangleMesh& mesh);

/// Result of one finding in an exercise.
enum class FindingVerdict : std::uint8_t
{
    Found,      ///< first finding at a target
    Again,      ///< at a target that was found before
    FalseAlarm, ///< at no target
    Late,       ///< after the time limit: not counted
    NotCounted  ///< a landmark or a place to keep away from: says nothing about a target
};

struct ScoredFinding
{
    core::Finding finding;
    double marked_s = 0.0; ///< since the start of the exercise
    FindingVerdict verdict = FindingVerdict::FalseAlarm;
    std::optional<std::size_t> target; ///< index; only for Found and Again
};

/// Result of one target. The optional fields are empty for a target that was missed.
struct ScoredTarget
{
    std::string name;
    TargetBall ball;
    std::optional<double> found_s;     ///< since the start of the exercise
    std::optional<double> distance_mm; ///< from the finding to the ball; negative inside the ball
};

/// Force above the ceiling of an exercise.
struct ForceAbove
{
    double time_s = 0.0;
    double impulse_Ns = 0.0; ///< force minus ceiling, summed over time
};

/// Score of an exercise; definitions in docs/exercise.md.
struct ExerciseScore
{
    meshio::Exercise exercise;
    double within_mm = 0.0;            ///< distance from a target within which a finding counts
    double coverageDistance_mm = 0.0;  ///< distance within which the contact covers a surface point
    double duration_s = 0.0;           ///< recorded time, at most the time limit
    std::vector<ScoredTarget> targets; ///< in the order of the exercise
    std::vector<ScoredFinding> findings;
    double searched_mm2 = 0.0;       ///< area of the palpable structures that are no targets
    double covered_mm2 = 0.0;        ///< covered part of searched_mm2
    std::optional<ForceAbove> above; ///< empty without a force ceiling
    double peakForce_N = 0.0;
    std::int64_t lostTicks = 0;            ///< ticks dropped because the disk was too slow
    std::vector<std::string> unmeasured{}; ///< structures without a surface, missing in searched_mm2
    std::vector<core::Message> damaged{};  ///< data with failed checksums

    [[nodiscard]] PALPATE_EXPORT std::size_t found() const noexcept;
    [[nodiscard]] PALPATE_EXPORT std::size_t count(FindingVerdict verdict) const noexcept;
    /// Covered share of the searched surface; empty without one.
    [[nodiscard]] PALPATE_EXPORT std::optional<double> coverage() const noexcept;
};

/// Assigns findings to targets, in the order of time. A finding belongs to the target with the least distance from the
/// ball, of those within the distance: one that is not found yet if there is any.
/// @param findings  with the time since the start of the exercise [s], in the order of time; notes are left out
/// @param targets  updated
/// @param time_s  time limit; empty: none
[[nodiscard]] PALPATE_EXPORT std::vector<ScoredFinding>
matchFindings(const std::vector<std::pair<double, core::Finding>>& findings, std::vector<ScoredTarget>& targets,
              double within_mm, std::optional<double> time_s);

struct ExerciseOptions
{
    double within_mm = 10.0;          ///< see ExerciseScore, > 0
    double coverageDistance_mm = 5.0; ///< see ExerciseScore
};

/// Scores a recording of an exercise, which starts with the first tick.
/// @param meshes  surfaces of the recording
/// @return NotFound if a target is not in the recording or its surface is missing, or the error of `measureSession`
/// @par Thread Any. Do not use the reader from other threads at the same time.
[[nodiscard]] PALPATE_EXPORT core::Result<ExerciseScore> scoreExercise(const session::RecordingReader& reader,
                                                                       const session::MeshesByHash& meshes,
                                                                       const meshio::Exercise& exercise,
                                                                       const ExerciseOptions& options = {});

/// Serializes a score as one JSON document; see docs/exercise.md.
[[nodiscard]] PALPATE_EXPORT std::string exerciseJson(const ExerciseScore& score);
/// Names in files: "found", "again", "false alarm", "late", "not counted".
[[nodiscard]] PALPATE_EXPORT const char* nameOf(FindingVerdict verdict) noexcept;

} // namespace palpate::study
