// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/Recording.h"

#include <palpate/core/Finding.h>
#include <palpate/servo/TickRecord.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace palpate::session {

// A finding is the event "finding" of a recording: name, position, structure, and force, depth and note where there are
// some. The event "finding-undone", of the same content, takes back the newest finding of that name.

/// @return the event's `json`.
[[nodiscard]] std::string findingJson(const core::Finding& finding);
/// The findings that a recording ends with, each with the tick in which it was marked, by tick. What is not one, or has
/// no position, is left out.
[[nodiscard]] std::vector<std::pair<std::int64_t, core::Finding>> findingsOf(const std::vector<RecordingEvent>& events);

/// What the hand did at one finding; definitions in resources/docs/measures.md.
struct FindingMeasures
{
    core::Finding finding;
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
