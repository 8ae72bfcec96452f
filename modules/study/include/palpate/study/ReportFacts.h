// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/study/BuriedLumps.h"
#include "palpate/study/Distances.h"

#include <palpate/core/Export.h>
#include <palpate/core/Message.h>
#include <palpate/core/Status.h>
#include <palpate/core/Tape.h>
#include <palpate/meshio/LoadScene.h>
#include <palpate/session/MeasureSession.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/session/Replay.h>

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate::study {

struct ReportOptions
{
    std::filesystem::path scene; ///< scene of the recording; empty: as stored in the recording
    /// Used if the recording's own scene is not available and this one has all its surfaces. May be null.
    std::shared_ptr<const meshio::LoadedScene> opened;
    /// Findings of the open scene. Empty: those of the scene of the recording.
    std::optional<std::vector<core::Finding>> findings;
    /// Tapes of the open scene. Empty: those of the scene of the recording.
    std::optional<std::vector<core::Tape>> tapes;
    std::string caseText; ///< free text
    std::string examiner; ///< free text
    /// Progress callback (0 to 1) with the current step. May be empty.
    std::function<void(double share, const core::Message& step)> progress;
    const std::atomic<bool>* isCancelled = nullptr; ///< polled; may be null
};

/// Force over time, reduced to the smallest and greatest force of each of at most kSpans equal spans of time.
struct ForceCurve
{
    static constexpr std::size_t kSpans = 1200;
    struct Span
    {
        float least_N = 0.0F, greatest_N = 0.0F;
        bool isRecorded = false; ///< false: no tick in this span
    };
    struct Mark
    {
        double time_s = 0.0;
        std::size_t number = 0; ///< of the finding, from 1
    };
    std::vector<Span> spans;
    std::vector<Mark> marks;
    double duration_s = 0.0;
};

/// Distance within which a structure counts as a neighbour of a finding: the usual border of the widest band of
/// margins. [mm]
inline constexpr double kBesideFinding_mm = 10.0;

/// Result of checking a recording.
struct Verification
{
    core::Status checksums;                           ///< of database and ticks
    std::optional<session::Resimulation> resimulated; ///< empty: not computed again
    core::Message notResimulated;                     ///< why not
};

/// Everything that the report of a session states. Computed by the functions behind `session measure`,
/// `session verify`, `info` and `info --distances`, so that all numbers agree.
struct ReportFacts
{
    std::unique_ptr<session::RecordingReader> recording;
    std::string sha256; ///< of the recording's file, 64 hex digits
    std::string caseText, examiner;
    session::SessionMeasures measures;
    /// Findings of the scene with a place that the recording does not contain: marked before it, after its end or in
    /// another one.
    std::vector<core::Finding> outside;
    ForceCurve force;
    Verification verification;
    std::shared_ptr<const meshio::LoadedScene> scene; ///< null: not available
    std::optional<DistanceTable> distances;           ///< empty without a scene
    /// Structures with a surface within kBesideFinding_mm of a finding, by number in `distances`, ascending.
    std::vector<std::size_t> besideFindings;
    std::vector<core::Tape> tapes; ///< distances that the user measured in the scene
    std::vector<OrganPalpability> lumps;
    std::vector<core::Message> lumpNotes; ///< organs and lumps that cannot be evaluated, one sentence each
    std::vector<core::Message> missing;   ///< what is missing or damaged, one sentence each
};

/// Computes the facts of a report. Missing meshes, damage and interruptions are listed in `missing`.
/// @return the error of reading the recording or the scene in `options`; Cancelled
/// @par Cost About that of `session verify` and `session measure` together. One thread at a time, not for the servo
/// thread.
[[nodiscard]] PALPATE_EXPORT core::Result<ReportFacts> gatherReport(const std::filesystem::path& recording,
                                                                    const ReportOptions& options = {});

} // namespace palpate::study
