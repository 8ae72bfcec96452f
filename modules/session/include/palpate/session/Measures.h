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

/// Force and depth over the ticks in contact; definitions in resources/docs/measures.md.
struct ContactMeasures
{
    std::int64_t ticks = 0;
    double time_s = 0.0;
    double peakForce_N = 0.0;
    double meanForce_N = 0.0;
    double medianForce_N = 0.0;
    double p95Force_N = 0.0;
    double peakDepth_mm = 0.0; ///< of the distance between god-object and HIP
    double meanDepth_mm = 0.0;
    double p95Depth_mm = 0.0;
};

/// What a session says in numbers, without looking at the surfaces.
struct Measures
{
    std::int64_t ticks = 0;
    double duration_s = 0.0;
    double pathLength_mm = 0.0;  ///< of the HIP
    double contactPath_mm = 0.0; ///< of the god-object while it touches
    std::int64_t contacts = 0;   ///< how often the hand came onto a surface
    ContactMeasures contact;
    std::map<std::string, ContactMeasures, std::less<>> structures; ///< by name
};

/// @return true when `now` goes on where `before` was: no loss, restart or absent hand between them.
[[nodiscard]] bool follows(const std::optional<servo::TickRecord>& before, const servo::TickRecord& now) noexcept;

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
    struct Samples
    {
        std::vector<double> forces_N, depths_mm; ///< of contact ticks
    };
    [[nodiscard]] ContactMeasures summary(const Samples& samples) const;

    double m_dt_s;
    Measures m_sum;
    Samples m_all;
    std::map<std::string, Samples, std::less<>> m_structures;
    std::optional<servo::TickRecord> m_previous;
};

} // namespace palpate::session
