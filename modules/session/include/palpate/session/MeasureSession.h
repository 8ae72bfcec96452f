// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/Findings.h"
#include "palpate/session/Measures.h"
#include "palpate/session/Phases.h"
#include "palpate/session/RecordingReader.h"
#include "palpate/session/TouchedSurface.h"

#include <palpate/core/Status.h>
#include <palpate/geometry/MeshReport.h>

#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate::session {

/// Repaired meshes by geometryHash.
using MeshesByHash = std::map<std::string, std::shared_ptr<const geometry::RepairedMesh>>;

struct MeasureOptions
{
    /// How near the contact must come to a point of a surface, or to a finding, to have touched it: about the radius
    /// of a fingertip's contact. [mm]
    double distance_mm = 5.0;
    const std::atomic<bool>* isCancelled = nullptr; ///< asked now and then; may be null
};

/// What was done on one structure's surface.
struct SurfaceMeasures
{
    std::string structure;
    double area_mm2 = 0.0;
    double coveredArea_mm2 = 0.0;
    double longestDwell_s = 0.0;             ///< at one point
    std::unique_ptr<TouchedSurface> surface; ///< null when it was never touched
    [[nodiscard]] double coverage() const noexcept { return area_mm2 > 0.0 ? coveredArea_mm2 / area_mm2 : 0.0; }
};

/// How an organ was searched for one lump in it: see resources/docs/measures.md. All but `recorded_percent` is an
/// estimate, as what can be felt is.
struct LumpSearch
{
    std::string lump, organ;
    double told_mm2 = 0.0;    ///< of the organ's surface, where a trained hand tells the lump when it presses
    double pressed_mm2 = 0.0; ///< of that, where the hand pressed deep enough to
    /// Greatest change of the force under the hand over the lump, by that of the organ alone at the same depth, in the
    /// recording's own ticks [%]; nothing where none was deep enough to say.
    std::optional<double> recorded_percent;
    /// Greatest change of the stiffness that the model predicts for the places and depths reached [%]; nothing where
    /// the lump's stiffness ratio is not known.
    std::optional<double> predicted_percent;

    /// Nothing: no hand tells it from anywhere.
    [[nodiscard]] std::optional<double> share() const
    {
        return told_mm2 > 0.0 ? std::optional(pressed_mm2 / told_mm2) : std::nullopt;
    }
};

/// Everything that a session says in numbers; definitions in resources/docs/measures.md.
struct SessionMeasures
{
    double distance_mm = 0.0; ///< that was measured with
    Measures sums;
    std::vector<Phase> phases;                                 ///< of the hand as a whole
    std::map<std::string, std::vector<Phase>> structurePhases; ///< of each structure that was touched, by name
    std::vector<FindingMeasures> findings;
    std::vector<SurfaceMeasures> surfaces; ///< of each structure that could be felt and whose mesh is there
    std::vector<LumpSearch> lumps;         ///< empty here; see study/SearchedLumps.h
    std::vector<std::string> unmeasured;   ///< structures whose mesh is not there
    std::int64_t lostTicks = 0;            ///< that the disk was too slow for
    std::optional<std::int64_t> lateTicks; ///< periods that the servo left out; nothing: it is not said
    std::vector<std::string> damaged;      ///< what is not as it was written, see RecordingReader::faults
};

/// @return the least distance with which these surfaces are measured: they are split to triangles half as long, at
///         most some ten million, which take 3 GB. [mm]
[[nodiscard]] double leastDistance_mm(const MeshesByHash& meshes);

/// Reads a recording once and measures it. Ticks that are not as they were written are left out.
/// @param meshes  the surfaces that were felt, as far as they are there
/// @return OutOfRange for a distance below `leastDistance_mm`, Cancelled, or what could not be read
/// @par Thread Any; the reader must serve no other meanwhile.
[[nodiscard]] core::Result<SessionMeasures> measureSession(const RecordingReader& reader, const MeshesByHash& meshes,
                                                           const MeasureOptions& options = {});

} // namespace palpate::session
