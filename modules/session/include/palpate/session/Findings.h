// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/Recording.h"

#include <palpate/core/Finding.h>
#include <palpate/servo/TickRecord.h>

#include <QJsonObject>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace palpate::session {

// A finding is the event "finding" of a recording, a note without a place the event "note" (older recordings: its text
// alone). "finding-edited" says anew what the one of that id is; "finding-undone", of the same content, takes it back:
// by its id, in older recordings the newest of that name.

/// @return the event's `json`; where it was recorded is left out: here.
[[nodiscard]] std::string findingJson(const core::Finding& finding);
/// The same without what only an event needs. What a finding lacks is not said.
[[nodiscard]] QJsonObject toJson(const core::Finding& finding);
/// Reads what `toJson` wrote; a field that is missing or wrong is left out.
[[nodiscard]] core::Finding findingFrom(const QJsonObject& json);
/// The findings and notes that a recording ends with, each with the tick in which it was marked, by tick. What is none
/// is left out.
[[nodiscard]] std::vector<std::pair<std::int64_t, core::Finding>> findingsOf(const std::vector<RecordingEvent>& events);

/// What the hand did at one finding; definitions in resources/docs/measures.md.
struct FindingMeasures
{
    core::Finding finding;                ///< of a note the measures are zero
    double marked_s = 0.0;                ///< since the session's first tick
    std::optional<double> firstTouched_s; ///< when the contact first came within the distance; none: it never did
    double dwell_s = 0.0;                 ///< contact within the distance
    double meanForce_N = 0.0;             ///< over that dwell
    double peakForce_N = 0.0;
    double peakDepth_mm = 0.0;
    std::int64_t visits = 0; ///< how often the contact came within the distance
};

/// Adds up, tick by tick, what was done near each finding of a recording.
class FindingAccumulator
{
  public:
    /// @param distance_mm  from the finding to the god-object
    FindingAccumulator(const std::vector<RecordingEvent>& events, std::int64_t firstTick, double dt_s,
                       double distance_mm);
    void add(const servo::TickRecord& tick);
    [[nodiscard]] std::vector<FindingMeasures> result() const;

  private:
    std::int64_t m_firstTick;
    double m_dt_s;
    double m_distance_mm;
    struct Sum
    {
        FindingMeasures measures;
        std::int64_t ticks = 0;
        double force_N = 0.0;
        bool isThere = false;
    };
    std::vector<Sum> m_sums;
    std::optional<servo::TickRecord> m_previous;
};

} // namespace palpate::session
