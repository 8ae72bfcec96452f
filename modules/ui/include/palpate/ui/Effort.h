// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/study/EffortDepth.h>
#include <palpate/view/SurfacePicker.h>

#include <optional>
#include <vector>

namespace palpate::ui {

/// Force model for pointers without a force sensor. The force rises with the time of the press up to a limit; pen
/// pressure or the deflection of a 6-axis mouse sets a fraction of the limit instead. The caller provides the time.
///
/// @par Example
/// @code
/// Effort effort;
/// effort.setMost(5.0); // N
/// effort.begin(0.0); // the hand reaches the surface at t = 0 s
/// double f_N = effort.force_N(2.0); // 2 N: kRise_N_per_s times 2 s
/// @endcode
class PALPATE_EXPORT Effort
{
  public:
    static constexpr double kRise_N_per_s = 1.0;
    static constexpr double kLeast_N = 0.5; ///< lower bound of the limit
    static constexpr double kMost_N = 10.0; ///< upper bound of the limit
    static constexpr double kNotch_N = 0.5; ///< change of the limit per notch of the wheel
    static constexpr double kUsual_N = 5.0;

    /// Sets the force limit. @param most_N  clamped to kLeast_N … kMost_N
    void setMost(double most_N) noexcept;
    [[nodiscard]] double most_N() const noexcept { return m_most_N; }
    /// Changes the limit by notches of the wheel. Returns false when the bounds cut the change short.
    bool turn(double notches) noexcept;

    /// Starts a press. @param touches_s  time at which the hand reaches the surface; the force rises from then on
    void begin(double touches_s) noexcept { m_touches_s = touches_s; }
    void end() noexcept;
    /// Sets the pressure reported by a pen or 6-axis mouse, valid until `end`. @param share  fraction of full pressure,
    /// 0 to 1
    void setShare(double share) noexcept;
    /// Current force, 0 without a press. [N]
    [[nodiscard]] double force_N(double now_s) const noexcept;

  private:
    double m_most_N = kUsual_N;
    std::optional<double> m_touches_s; ///< Empty: not pressed
    std::optional<double> m_share;
};

/// Finds the surfaces on a straight press: for each layer the first surface that is touchable from this side.
/// @param press  starts at the hand's position; distances are measured from there
/// @param time_s  of the newest tick, for surfaces that move
/// @param fingertip_mm  radius of the fingertip; otherwise that of the scene
/// @return surfaces with pointers into `scene`
/// @par Cost O(log triangles) per structure.
[[nodiscard]] PALPATE_EXPORT std::vector<study::PressedSurface>
surfacesAlongPress(const haptics::HapticScene& scene, const view::Ray& press, double time_s = 0.0,
                   std::optional<double> fingertip_mm = {});

/// Finds where the centre of the fingertip is when a hand that moves along a ray first touches the palpable structure
/// that the ray meets. Structures beside the ray are passed.
/// @param hit_mm  distance of the surface on the ray [mm]
/// @param time_s  of the newest tick, for surfaces that move
/// @param fingertip_mm  radius of the fingertip; otherwise that of the scene
/// @return distance along the ray [mm], at most `hit_mm`; `hit_mm` for a point
/// @par Cost One query of `geometry::nearestPoint` per structure, and some ten for the structure that the ray meets.
[[nodiscard]] PALPATE_EXPORT double touchAlongRay_mm(const haptics::HapticScene& scene, const view::Ray& ray,
                                                     double hit_mm, double time_s = 0.0,
                                                     std::optional<double> fingertip_mm = {});

} // namespace palpate::ui
