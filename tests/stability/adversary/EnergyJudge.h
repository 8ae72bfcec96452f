// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/haptics/Palpator.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace palpate::adversary {

using core::Vec3;

/// Sums what a hand puts into a tissue and what that stores, tick by tick: no tick gives more than was there. With
/// `E = s(x) W(d)` and f the elastic force after the tick,
///
///     E' - E <= -f' . dp + what a map's own slope can make in a step of that length
///
/// The energy is convex in depth, and friction only takes; but s W is not convex: a step that goes deeper and over to
/// where s is another one may be off by `|ds| |dW|`, which vanishes with its square. With friction a map's pull is left
/// out of the force, and what friction takes must make up for it.
/// Where it can be told from the formulas alone: on the face of one triangle before and after.
class EnergyJudge
{
  public:
    void forget() { m_last.reset(); }
    /// @param structures  by number in the scene; @param v_WH  velocity of the hand, for the damper [mm/s]
    /// @param rounding_mm  of a coordinate, or how well else the god-object's place is known
    /// @return energy that the tick made from nothing [mJ], 0 where it made none or that can't be told
    [[nodiscard]] double made_mJ(const std::vector<haptics::HapticStructure>& structures,
                                 const haptics::TickResult& tick, const Vec3& hip, const Vec3& v_WH,
                                 double rounding_mm);
    /// Ticks that were told.
    [[nodiscard]] std::int64_t ticks() const { return m_ticks; }

  private:
    struct Touch
    {
        std::uint32_t structure, triangle;
        Vec3 hip, god;
        double s, damping, W;
        double slope_per_mm, dampingSlope; ///< |grad s|, |grad b|
    };
    [[nodiscard]] static std::optional<Touch> touchOf(const std::vector<haptics::HapticStructure>& structures,
                                                      const haptics::TickResult& tick, const Vec3& hip);

    std::optional<Touch> m_last;
    std::int64_t m_ticks = 0;
};

} // namespace palpate::adversary
