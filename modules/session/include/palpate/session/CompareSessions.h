// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/MeasureSession.h"

#include <palpate/core/Export.h>
#include <palpate/core/Message.h>
#include <palpate/core/Status.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace palpate::session {

/// Smallest difference between two forces that a hand can tell, relative to the first force [%]: about 7 % from 2.5 to
/// 10 N (Pang, Tan & Durlach, Perception & Psychophysics 49, 1991). Not known below 2.5 N.
inline constexpr double kForceThreshold_percent = 7.0;

/// Which of two sessions touched a place.
enum class TouchedBy : std::uint8_t
{
    Neither,
    First,
    Second,
    Both
};

[[nodiscard]] constexpr TouchedBy touchedBy(bool isFirst, bool isSecond) noexcept
{
    return isFirst ? (isSecond ? TouchedBy::Both : TouchedBy::First)
                   : (isSecond ? TouchedBy::Second : TouchedBy::Neither);
}

/// One measure of two sessions; definitions in docs/measures.md.
struct ComparedMeasure
{
    const char* key = "";                ///< name in JSON, with the unit
    core::Message name;                  ///< with the unit
    int digits = 4;                      ///< significant digits to show
    bool isForce = false;                ///< a magnitude of force, to which the threshold applies
    std::optional<double> first, second; ///< empty: this session has no such value, for example never touched

    [[nodiscard]] PALPATE_EXPORT std::optional<double> difference() const; ///< second - first
    /// Difference relative to the first. Empty if the first is zero or a value is missing. [%]
    [[nodiscard]] PALPATE_EXPORT std::optional<double> difference_percent() const;
    /// True if a hand can tell the two forces apart: see kForceThreshold_percent. Empty for other measures, and
    /// without both values.
    [[nodiscard]] PALPATE_EXPORT std::optional<bool> isNoticeable() const;
};

/// Measures of the whole session, or of one structure or lump.
struct ComparedGroup
{
    std::string structure; ///< empty: the whole session
    bool isSearch = false; ///< how thoroughly `structure`, a lump, was searched for
    std::vector<ComparedMeasure> measures;
};

/// Surface of one structure, divided by who touched it.
struct ComparedSurface
{
    std::string structure;
    double area_mm2 = 0.0;
    double both_mm2 = 0.0, onlyFirst_mm2 = 0.0, onlySecond_mm2 = 0.0;
};

/// Two sessions on the same surfaces.
struct SessionComparison
{
    double distance_mm = 0.0;              ///< distance within which a place counts as touched
    std::vector<ComparedGroup> groups;     ///< the whole session, then the structures touched in either, then the lumps
    std::vector<ComparedSurface> surfaces; ///< palpable structures with an available mesh
};

/// Checks that two recordings have the same palpable surfaces, by name and geometryHash.
/// @return BadCommandLine, naming a surface that differs
[[nodiscard]] PALPATE_EXPORT core::Status checkSameSurfaces(const RecordingReader& first,
                                                            const RecordingReader& second);

/// Compares the measures of two sessions.
/// @param first,  second  measured with the same distance and the same surfaces
[[nodiscard]] PALPATE_EXPORT SessionComparison compareSessions(const SessionMeasures& first,
                                                               const SessionMeasures& second);

} // namespace palpate::session
