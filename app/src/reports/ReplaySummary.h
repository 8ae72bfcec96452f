// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Message.h>
#include <palpate/session/Measures.h>
#include <palpate/session/Replay.h>
#include <palpate/session/StructureNames.h>

#include <QJsonArray>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace palpate::app {

/// Preparation costs of a scene.
struct SceneCost
{
    std::string name; ///< file name
    std::size_t structures = 0;
    std::size_t triangles = 0;
    std::size_t bytes = 0;            ///< memory of all haptic surfaces
    double load_s = 0.0;              ///< time for reading and repairing
    double index_s = 0.0;             ///< time for building the haptic surfaces
    std::vector<core::Message> notes; ///< notes on the surfaces for the user, one sentence each
};

/// Quantiles of a duration, by nearest rank. [ns]
struct SolveTimes
{
    std::uint32_t p50 = 0, p99 = 0, p999 = 0, max = 0;
    double mean = 0.0;
};

/// Collects the results printed at the end of a replay.
class ReplaySummary
{
  public:
    ReplaySummary(SceneCost cost, double dt_s);

    void reserve(std::size_t ticks);
    void add(const servo::TickRecord& tick, const session::StructureNames& names);
    void setResimulation(const session::Resimulation& result) { m_resimulation = result; }
    /// Sets real-time results. @param lost  ticks of the motion that were not simulated
    void setLive(std::int64_t lost, std::uint64_t overruns) { m_lost = lost, m_overruns = overruns; }

    /// Sets the palpability of the scene's lumps. @param lines  text; @param json  the same as data
    void setLumps(std::vector<std::string> lines, QJsonArray json)
    {
        m_lumpLines = std::move(lines);
        m_lumps = std::move(json);
    }

    [[nodiscard]] SolveTimes solveTimes() const;
    void print() const;
    [[nodiscard]] std::string json() const;

  private:
    SceneCost m_cost;
    session::MeasureAccumulator m_measures;
    std::vector<std::uint32_t> m_solve_ns;
    std::int64_t m_iterationBounds = 0;
    std::uint32_t m_mostIterations = 0;
    std::int64_t m_gated = 0;
    std::optional<session::Resimulation> m_resimulation;
    std::optional<std::int64_t> m_lost;
    std::uint64_t m_overruns = 0;
    std::vector<std::string> m_lumpLines;
    QJsonArray m_lumps;
};

} // namespace palpate::app
