// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/Recording.h"

#include <palpate/core/Export.h>
#include <palpate/core/Finding.h>
#include <palpate/servo/TickRecord.h>

#include <QJsonObject>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace palpate::session {

// Findings are stored as recording events: "finding" with a position, "note" without one (older recordings store only
// the text of a note). "finding-edited" replaces the content of the finding with the same id. "finding-undone" carries
// the content of a finding and removes it, matched by id or, in older recordings, the newest finding of that name.

/// Serializes a finding for the event's `json`. The place of recording is left out because the event is stored there.
[[nodiscard]] PALPATE_EXPORT std::string findingJson(const core::Finding& finding);
/// Serializes a finding without the fields that only an event needs. Unset fields are omitted.
[[nodiscard]] PALPATE_EXPORT QJsonObject toJson(const core::Finding& finding);
/// Parses the output of `toJson`. Missing or invalid fields keep their defaults.
[[nodiscard]] PALPATE_EXPORT core::Finding findingFrom(const QJsonObject& json);
/// Returns the findings and notes that remain at the end of a recording, each with the tick at which the user marked
/// the finding, in tick order. Invalid events are skipped.
[[nodiscard]] PALPATE_EXPORT std::vector<std::pair<std::int64_t, core::Finding>>
findingsOf(const std::vector<RecordingEvent>& events);

/// Hand activity near one finding; definitions in docs/measures.md.
struct FindingMeasures
{
    core::Finding finding;                ///< all measures of a note are zero
    double marked_s = 0.0;                ///< time since the first tick of the session
    std::optional<double> firstTouched_s; ///< first time the contact came within the distance; empty if never
    double dwell_s = 0.0;                 ///< contact time within the distance
    double meanForce_N = 0.0;             ///< mean over the dwell time
    double peakForce_N = 0.0;
    double peakDepth_mm = 0.0;
    std::int64_t visits = 0; ///< number of times the contact came within the distance
};

/// Accumulates FindingMeasures for each finding of a recording, tick by tick.
class PALPATE_EXPORT FindingAccumulator
{
  public:
    /// @param distance_mm  maximum distance between finding and god-object [mm]
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
