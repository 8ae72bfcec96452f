// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/StructureNames.h"

#include <palpate/servo/TickRecord.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace palpate::session {

/// Force and depth over the ticks in contact; definitions in resources/docs/measures.md.
struct ContactMeasures
{
    std::int64_t ticks = 0;
    std::int64_t contacts = 0; ///< how often the hand came onto it
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
    double contactPath_mm = 0.0; ///< of the reported god-object while it touches
    ContactMeasures contact;     ///< of the whole force; the depth is that of the outermost layer that is touched
    /// By name, of each layer's own share of the force and own depth.
    std::map<std::string, ContactMeasures, std::less<>> structures;
};

/// @return true when `now` goes on where `before` was: no loss, restart or absent hand between them.
[[nodiscard]] bool follows(const std::optional<servo::TickRecord>& before, const servo::TickRecord& now) noexcept;

/// Adds up measures tick by tick. Forces are the model's, before any device limit.
class MeasureAccumulator
{
  public:
    /// @param dt_s  what a tick lasts [s]
    explicit MeasureAccumulator(double dt_s);
    void add(const servo::TickRecord& tick, const StructureNames& names);
    [[nodiscard]] Measures result() const;

  private:
    struct Samples
    {
        void add(std::int64_t tick, bool goesOn, double force_N, double depth_mm);
        std::vector<double> forces_N, depths_mm; ///< of contact ticks
        std::int64_t contacts = 0;
        std::optional<std::int64_t> last; ///< tick in contact
    };
    [[nodiscard]] ContactMeasures summary(const Samples& samples) const;

    double m_dt_s;
    Measures m_sum;
    Samples m_all;
    std::map<std::string, Samples, std::less<>> m_structures;
    std::optional<servo::TickRecord> m_previous;
};

} // namespace palpate::session
