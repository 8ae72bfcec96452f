// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Types.h>
#include <palpate/device/PointerDevice.h>

#include <optional>

namespace palpate::ui {

using core::Vec3;

/// Parameters of a hand driven by mouse or pen.
struct PointerHandSettings
{
    double hover_mm = 2.0;     ///< gap to the surface while nothing is pressed
    double depth_mm = 4.0;     ///< depth of a press
    double step_mm = 0.5;      ///< one wheel notch; more from 20 steps on, see `turnDepth`
    double deepest_mm = 200.0; ///< upper bound of the depth
    double pressTime_s = 0.15; ///< duration of a shallow press, long enough to feel like pressing instead of a knock
    double easeThreshold_mm = 6.0;     ///< longest travel that takes pressTime_s
    double pressSpeed_mm_per_s = 20.0; ///< speed of the remaining travel while the press is held
    double liftTime_s = 0.10;
    double stride_mm = 2.0; ///< one step along the screen by keys
};

/// Returns settings scaled to the scene, so that a vessel and a whole body are pressed by a similar fraction of their
/// size. The default depth of 4 mm applies from 200 mm on. A press can reach through the whole scene.
[[nodiscard]] PALPATE_EXPORT PointerHandSettings settingsForSize(double diagonal_mm);

/// Converts pointer motion over a surface into motion of a hand: hovering above the picked point, pressing along the
/// line of sight to the set depth, sliding on drag, lifting off on release. The device performs the motion tick by
/// tick.
///
/// The caller provides the time, so that equal input gives equal states. A hovering hand is reported to the device as
/// absent (`isPresent` false), because a pointer jumps between places and a god-object would be caught inside tissue.
///
/// @par Example
/// @code
/// PointerHand hand;
/// hand.setSettings(settingsForSize(300.0)); // scene diagonal in mm
/// hand.pointAt(Vec3(0, 0, 500), Vec3(0, 0, -1), Vec3(0, 0, 100)); // eye, direction, picked point
/// hand.press();
/// device::PointerState state = hand.state(0.1); // time in s
/// @endcode
class PALPATE_EXPORT PointerHand
{
  public:
    enum class Phase
    {
        Away,
        Hovering,
        Pressing,
        Lifting
    };

    void setSettings(const PointerHandSettings& settings);
    [[nodiscard]] const PointerHandSettings& settings() const noexcept { return m_settings; }

    /// Sets the line of sight and the picked surface point, if any. During a press the depth plane is kept when the
    /// pointer leaves the surface or crosses the rim of a structure in front.
    /// @param d_W  unit vector away from the viewer
    void pointAt(const Vec3& eye_W, const Vec3& d_W, const std::optional<Vec3>& surface_W);
    /// Releases immediately: the pointer has left the view, or palpation was switched off.
    void goAway();
    void press();
    void release(double now_s);
    /// Changes the depth by wheel notches, clamped to 0 … `deepest_mm`. A notch is `step_mm`, doubled from 20 steps on,
    /// four times from 40 and ten times from 100. With 0.5 mm steps: 1 mm from 10 mm on, 2 mm from 20 mm, 5 mm from 50
    /// mm.
    /// @return false when the bounds cut the change short
    bool turnDepth(double notches);
    /// Changes the depth by multiples of `step_mm`; otherwise as `turnDepth`.
    bool stepDepth(int steps);
    /// Sets the target depth of a press instead of the configured depth; empty restores the configured depth. Clamped
    /// to -`hover_mm` … `deepest_mm`. [mm]
    void setAim(std::optional<double> depth_mm);

    [[nodiscard]] Phase phase(double now_s) const;
    /// Hover position; empty while away. [mm]
    [[nodiscard]] std::optional<Vec3> hoverPoint() const;
    /// State for the device, which performs press and lift-off motions, see device/PointerDevice.h. Bit 0 of `buttons`
    /// is the press.
    [[nodiscard]] device::PointerState state(double now_s) const;

    /// Reference point of the depth; empty while away. [mm]
    [[nodiscard]] const std::optional<Vec3>& surfacePoint() const noexcept { return m_surface_W; }
    /// Press direction, unit vector.
    [[nodiscard]] const Vec3& direction() const noexcept { return m_d_W; }
    /// Depth of a place below the picked surface point along the line of sight. [mm]
    [[nodiscard]] double pressedDepth_mm(const Vec3& p_W) const;

  private:
    bool setDepth(double depth_mm);

    PointerHandSettings m_settings;
    std::optional<Vec3> m_surface_W; ///< reference point of the depth
    Vec3 m_d_W = Vec3::UnitZ();
    std::optional<double> m_aim_mm; ///< overrides the configured depth
    bool m_isDown = false;
    double m_release_s = -1.0; ///< time of release; < 0: hovering
};

} // namespace palpate::ui
