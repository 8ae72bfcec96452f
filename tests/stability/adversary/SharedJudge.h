// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/haptics/Palpator.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace palpate::adversary {

using core::Vec3;

/// Checks the force of a god-object held by several structures that are plain springs without damping: the force is
/// between the responses of the softest and of the stiffest alone, its parts add up to the total, and its change per
/// tick is within the bound in resources/docs/god-object.md.
class SharedJudge
{
  public:
    void forget() { m_last.reset(); }
    /// @param structures  by number in the scene
    /// @param rounding_mm  of a coordinate
    /// @param isPoint  point instead of a ball
    /// @return description of the violation; null if correct
    [[nodiscard]] const char* look(const std::vector<haptics::HapticStructure>& structures,
                                   const haptics::TickResult& tick, const Vec3& hip, double rounding_mm, bool isPoint);
    /// Returns the number of checked ticks with several structures.
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

/// Returns whether the planes that hold the god-object belong to several structures.
[[nodiscard]] bool isOfSeveral(const haptics::TickResult& tick);

} // namespace palpate::adversary
