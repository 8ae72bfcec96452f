// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/servo/TickRecord.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace palpate::session {

/// Faster over the surface than this is searching, slower is pressing. [mm/s]
inline constexpr double kSearchSpeed_mm_per_s = 10.0;
/// The speed is taken over this long. [s]
inline constexpr double kPhaseBlock_s = 0.1;

/// A stretch of contact in which the hand did one thing.
struct Phase
{
    enum class Kind
    {
        Search, ///< the god-object moves over the surface
        Press   ///< it stays about where it is
    };
    Kind kind = Kind::Press;
    std::int64_t firstTick = 0;
    std::int64_t ticks = 0;
    double start_s = 0.0; ///< since the session's first tick
    double time_s = 0.0;
    double meanForce_N = 0.0;
    double peakForce_N = 0.0;
};

/// All phases of one kind.
struct PhaseSummary
{
    std::int64_t phases = 0;
    double time_s = 0.0;
    double meanForce_N = 0.0; ///< over its ticks
    double peakForce_N = 0.0;
};

[[nodiscard]] PhaseSummary summary(const std::vector<Phase>& phases, Phase::Kind kind);

/// Tells searching from pressing, tick by tick; definition in resources/docs/measures.md.
class PhaseAccumulator
{
  public:
    /// @param firstTick  of the session; none: the first that is added
    explicit PhaseAccumulator(double dt_s, std::optional<std::int64_t> firstTick = {});
    /// Takes what the hand did as a whole: the reported god-object and all of the force.
    void add(const servo::TickRecord& tick);
    /// Takes what it did on one structure. @param touched  its contact in this tick, null: none
    void add(const servo::TickRecord& tick, const haptics::Contact* touched);
    [[nodiscard]] std::vector<Phase> result() const;

  private:
    /// Consecutive ticks in contact, at most kPhaseBlock_s of them.
    struct Block
    {
        Phase phase;
        core::Vec3 first_WG = core::Vec3::Zero(), last_WG = core::Vec3::Zero();
        double sumForce_N = 0.0;
        bool goesOn = false; ///< the contact was there before it
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
    bool m_isOpen = false; ///< the contact has lasted since the last phase
};

} // namespace palpate::session
