// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/StructureNames.h"

#include <palpate/core/Export.h>
#include <palpate/servo/TickRecord.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace palpate::session {

/// Force and depth statistics over the ticks in contact; definitions in docs/measures.md.
struct ContactMeasures
{
    std::int64_t ticks = 0;
    std::int64_t contacts = 0; ///< number of contact onsets
    double time_s = 0.0;
    double peakForce_N = 0.0;
    double meanForce_N = 0.0;
    double medianForce_N = 0.0;
    double p95Force_N = 0.0;
    double peakDepth_mm = 0.0; ///< depth: distance between god-object and HIP
    double meanDepth_mm = 0.0;
    double p95Depth_mm = 0.0;
};

/// Measures of a session that do not require the surfaces.
struct Measures
{
    std::int64_t ticks = 0;
    double duration_s = 0.0;
    double pathLength_mm = 0.0;  ///< path of the HIP
    double contactPath_mm = 0.0; ///< path of the reported god-object while in contact
    ContactMeasures contact;     ///< total force; depth in the outermost layer in contact
    /// Measures per structure name, from the force and depth of that structure's own layer.
    std::map<std::string, ContactMeasures, std::less<>> structures;
};

/// Returns true if `now` continues from `before`: no lost tick, restart of the god-object or absent hand between them.
[[nodiscard]] PALPATE_EXPORT bool follows(const std::optional<servo::TickRecord>& before,
                                          const servo::TickRecord& now) noexcept;

/// Accumulates measures tick by tick. Forces are the model's, before any device limit.
class PALPATE_EXPORT MeasureAccumulator
{
  public:
    /// @param dt_s  duration of a tick [s]
    explicit MeasureAccumulator(double dt_s);
    void add(const servo::TickRecord& tick, const StructureNames& names);
    [[nodiscard]] Measures result() const;

  private:
    struct Samples
    {
        void add(std::int64_t tick, bool goesOn, double force_N, double depth_mm);
        std::vector<double> forces_N, depths_mm; ///< samples of the ticks in contact
        std::int64_t contacts = 0;
        std::optional<std::int64_t> last; ///< last tick in contact
    };
    [[nodiscard]] ContactMeasures summary(const Samples& samples) const;

    double m_dt_s;
    Measures m_sum;
    Samples m_all;
    std::map<std::string, Samples, std::less<>> m_structures;
    std::optional<servo::TickRecord> m_previous;
};

} // namespace palpate::session
