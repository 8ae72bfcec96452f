// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/haptics/Palpator.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace palpate::adversary {

using core::Vec3;

/// Judges the force of a god-object that several structures hold, where all of them are plain springs without damping:
/// it lies between what the softest and the stiffest of them would answer alone, its parts add up to it, and from tick
/// to tick it changes by no more than resources/docs/god-object.md says.
class SharedJudge
{
  public:
    void forget() { m_last.reset(); }
    /// @param structures  by number in the scene; @param rounding_mm  of a coordinate; @param isPoint  no ball
    /// @return what is wrong; null: nothing
    [[nodiscard]] const char* look(const std::vector<haptics::HapticStructure>& structures,
                                   const haptics::TickResult& tick, const Vec3& hip, double rounding_mm, bool isPoint);
    /// Ticks with several structures that were judged.
    [[nodiscard]] std::int64_t ticks() const { return m_ticks; }

  private:
    struct Held
    {
        haptics::TickResult tick;
        Vec3 spring;
        double stiffest;
    };
    [[nodiscard]] static bool changesAsMayBe(const Held& before, const Held& now, double rounding_mm);

    std::optional<Held> m_last;
    std::int64_t m_ticks = 0;
};

/// True when the planes that hold the god-object belong to several structures.
[[nodiscard]] bool isOfSeveral(const haptics::TickResult& tick);

} // namespace palpate::adversary
