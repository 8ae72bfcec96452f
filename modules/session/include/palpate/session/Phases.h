// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/servo/TickRecord.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace palpate::session {

/// Threshold of the tangential contact speed between searching (faster) and pressing (slower) [mm/s].
inline constexpr double kSearchSpeed_mm_per_s = 10.0;
/// Averaging interval of the contact speed [s].
inline constexpr double kPhaseBlock_s = 0.1;

/// Interval of contact with a single kind of hand movement.
struct Phase
{
    enum class Kind
    {
        Search, ///< the god-object moves over the surface
        Press   ///< the god-object is nearly stationary
    };
    Kind kind = Kind::Press;
    std::int64_t firstTick = 0;
    std::int64_t ticks = 0;
    double start_s = 0.0; ///< time since the first tick of the session
    double time_s = 0.0;
    double meanForce_N = 0.0;
    double peakForce_N = 0.0;
};

/// Totals over all phases of one kind.
struct PhaseSummary
{
    std::int64_t phases = 0;
    double time_s = 0.0;
    double meanForce_N = 0.0; ///< mean over the ticks of these phases
    double peakForce_N = 0.0;
};

[[nodiscard]] PALPATE_EXPORT PhaseSummary summary(const std::vector<Phase>& phases, Phase::Kind kind);

/// Classifies contact into searching and pressing, tick by tick; definition in docs/measures.md.
class PALPATE_EXPORT PhaseAccumulator
{
  public:
    /// @param firstTick  first tick of the session; defaults to the first added tick
    explicit PhaseAccumulator(double dt_s, std::optional<std::int64_t> firstTick = {});
    /// Adds a tick with the reported god-object and the total force.
    void add(const servo::TickRecord& tick);
    /// Adds a tick for a single structure.
    /// @param touched  contact with the structure in this tick; null if none
    void add(const servo::TickRecord& tick, const haptics::Contact* touched);
    [[nodiscard]] std::vector<Phase> result() const;

  private:
    /// Consecutive ticks in contact, at most kPhaseBlock_s long.
    struct Block
    {
        Phase phase;
        core::Vec3 first_WG = core::Vec3::Zero(), last_WG = core::Vec3::Zero();
        double sumForce_N = 0.0;
        bool goesOn = false; ///< continues the contact of the previous block
    };
    struct Touch
    {
        core::Vec3 p_WG;
        double force_N;
    };
    void take(const servo::TickRecord& tick, const std::optional<Touch>& touch);
    void close(std::vector<Phase>& phases, bool& isOpen) const;

    double m_dt_s;
    std::int64_t m_blockTicks;
    std::optional<std::int64_t> m_firstTick; ///< of the session
    std::optional<servo::TickRecord> m_previous;
    bool m_wasTouching = false;
    std::optional<Block> m_block;
    std::vector<Phase> m_phases;
    bool m_isOpen = false; ///< contact without a break since the last phase
};

} // namespace palpate::session
