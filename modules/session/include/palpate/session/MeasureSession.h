// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/Findings.h"
#include "palpate/session/Measures.h"
#include "palpate/session/Phases.h"
#include "palpate/session/RecordingReader.h"
#include "palpate/session/TouchedSurface.h"
#include "palpate/session/TouchedSurfaces.h"

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate::session {

struct MeasureOptions
{
    /// Distance within which the contact counts as touching a surface point or a finding [mm]. The default is about the
    /// radius of a fingertip's contact.
    double distance_mm = 5.0;
    /// Progress callback (0 to 1). Return false to cancel. May be empty.
    std::function<bool(double)> progress{};
    /// Receives each tick, in order, so that other sums need no pass of their own. May be empty.
    std::function<void(const servo::TickRecord&)> sink{};
    /// Ticks after this one are not measured.
    std::int64_t lastTick = std::numeric_limits<std::int64_t>::max();
};

/// Measures for the surface of one structure.
struct SurfaceMeasures
{
    std::string structure;
    double area_mm2 = 0.0;
    double coveredArea_mm2 = 0.0;
    double longestDwell_s = 0.0;             ///< maximum over all surface points
    std::unique_ptr<TouchedSurface> surface; ///< null if never touched
    [[nodiscard]] double coverage() const noexcept { return area_mm2 > 0.0 ? coveredArea_mm2 / area_mm2 : 0.0; }
};

/// How thoroughly an organ was searched for one of its lumps; see docs/measures.md. All fields except
/// `recorded_percent` are model estimates.
struct LumpSearch
{
    std::string lump, organ;
    double detectable_mm2 = 0.0; ///< organ surface from which a trained hand detects the lump when pressing
    double pressed_mm2 = 0.0;    ///< part of detectable_mm2 where the hand pressed deep enough
    /// Greatest relative change of force over the lump, compared with the organ alone at the same depth, from the
    /// recorded ticks [%]. Empty if no tick was deep enough.
    std::optional<double> recorded_percent;
    /// Greatest relative change of stiffness predicted by the model for the places and depths reached [%]. Empty if the
    /// lump's stiffness ratio is unknown.
    std::optional<double> predicted_percent;

    /// Searched fraction of the detectable area. Empty if the lump cannot be detected from anywhere.
    [[nodiscard]] std::optional<double> share() const
    {
        return detectable_mm2 > 0.0 ? std::optional(pressed_mm2 / detectable_mm2) : std::nullopt;
    }
};

/// All measures of a session; definitions in docs/measures.md.
struct SessionMeasures
{
    double distance_mm = 0.0; ///< distance used for the measurement
    Measures sums;
    std::vector<Phase> phases;                                 ///< from the overall contact
    std::map<std::string, std::vector<Phase>> structurePhases; ///< per touched structure, by name
    std::vector<FindingMeasures> findings;
    std::vector<SurfaceMeasures> surfaces; ///< all palpable structures with an available mesh
    std::vector<LumpSearch> lumps;         ///< not filled in here; see study/SearchedLumps.h
    std::vector<std::string> unmeasured;   ///< structures without an available mesh
    std::int64_t lostTicks = 0;            ///< ticks dropped because the disk was too slow
    std::optional<std::int64_t> lateTicks; ///< periods skipped by the servo; empty if unknown
    std::vector<core::Message> damaged;    ///< data with failed checksums, see RecordingReader::faults
};

/// Returns the smallest measuring distance for these surfaces [mm]. Triangles are split to edges of half the distance;
/// the limit keeps their number below about ten million (3 GB).
[[nodiscard]] PALPATE_EXPORT double minDistance_mm(const MeshesByHash& meshes);

/// Measures a recording in a single pass. Ticks with a failed checksum are skipped.
/// @param meshes  available surfaces of the palpable structures
/// @return OutOfRange for a distance below `minDistance_mm`, Cancelled, or the read error
/// @par Thread Any. Do not use the reader from other threads at the same time.
[[nodiscard]] PALPATE_EXPORT core::Result<SessionMeasures>
measureSession(const RecordingReader& reader, const MeshesByHash& meshes, const MeasureOptions& options = {});

} // namespace palpate::session
