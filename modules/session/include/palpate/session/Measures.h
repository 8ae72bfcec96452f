// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/servo/TickRecord.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::session {

/// What the hand did to one structure.
struct StructureMeasures
{
    double contactTime_s = 0.0;
    double peakForce_N = 0.0;
    double meanForce_N = 0.0;  ///< over its contact time
    double peakDepth_mm = 0.0; ///< largest distance between god-object and HIP
};

/// What a session says in numbers; definitions in resources/docs/measures.md.
struct Measures
{
    std::int64_t ticks = 0;
    std::int64_t contactTicks = 0;
    double duration_s = 0.0;
    double contactTime_s = 0.0;
    double pathLength_mm = 0.0;  ///< of the HIP
    double contactPath_mm = 0.0; ///< of the god-object while it touches
    double peakForce_N = 0.0;
    double meanForce_N = 0.0; ///< over contact
    double p95Force_N = 0.0;  ///< over contact
    double peakDepth_mm = 0.0;
    std::map<std::string, StructureMeasures, std::less<>> structures; ///< by name
};

/// Adds up measures tick by tick. Forces are the model's, before any device limit.
class MeasureAccumulator
{
  public:
    /// @param dt_s  what a tick lasts [s]
    explicit MeasureAccumulator(double dt_s);
    /// @param structure  name of the touched structure, empty in free space
    void add(const servo::TickRecord& tick, std::string_view structure);
    [[nodiscard]] Measures result() const;

  private:
    double m_dt_s;
    Measures m_sum;
    std::vector<double> m_forces; ///< [N], of contact ticks
    std::optional<servo::TickRecord> m_previous;
};

} // namespace palpate::session
