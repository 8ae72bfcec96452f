// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/haptics/HapticScene.h>
#include <palpate/study/EffortDepth.h>
#include <palpate/view/SurfacePicker.h>

#include <optional>
#include <vector>

namespace palpate::ui {

/// The force of a hand that has no sensor for it: the longer a press is held the harder it is, up to a bound; a pen's
/// pressure or the push of a 6-axis mouse says which share of the bound it is. Time comes from the caller.
class Effort
{
  public:
    static constexpr double kRise_N_per_s = 1.0;
    static constexpr double kLeast_N = 0.5; ///< the bound is at least this …
    static constexpr double kMost_N = 10.0; ///< … and at most this
    static constexpr double kNotch_N = 0.5; ///< of the wheel
    static constexpr double kUsual_N = 5.0;

    /// @param most_N  taken to the nearest that a bound may be
    void setMost(double most_N) noexcept;
    [[nodiscard]] double most_N() const noexcept { return m_most_N; }
    /// Changes the bound by notches of the wheel. @return false when that was not all possible
    bool turn(double notches) noexcept;

    /// A press begins. @param touches_s  when the hand comes to the surface: the force rises from then on
    void begin(double touches_s) noexcept { m_touches_s = touches_s; }
    void end() noexcept;
    /// A pen or puck says how hard it is pressed. @param share  0 … 1 of what it can say; until `end`
    void setShare(double share) noexcept;
    /// 0 while nothing is pressed. [N]
    [[nodiscard]] double force_N(double now_s) const noexcept;

  private:
    double m_most_N = kUsual_N;
    std::optional<double> m_touches_s; ///< nothing: not pressed
    std::optional<double> m_share;
};

/// The surfaces that a straight press meets: of each layer the first that can be touched from this side.
/// @param press  from where the hand begins; the ways are counted from there
/// @return with pointers into `scene`. @par Cost O(log triangles) for each structure.
[[nodiscard]] std::vector<study::PressedSurface> surfacesInTheWay(const haptics::HapticScene& scene,
                                                                  const view::Ray& press);

} // namespace palpate::ui
