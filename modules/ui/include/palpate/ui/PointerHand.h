// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>
#include <palpate/device/PointerDevice.h>

#include <optional>

namespace palpate::ui {

using core::Vec3;

/// How a hand that is a mouse or pen feels.
struct PointerHandSettings
{
    double hover_mm = 2.0;     ///< gap to the surface while nothing is pressed
    double depth_mm = 4.0;     ///< how far a press goes in
    double step_mm = 0.5;      ///< one notch of the wheel; from 20 of them on a notch is more, see `turnDepth`
    double deepest_mm = 200.0; ///< the wheel stops here
    double pressTime_s = 0.15; ///< a press goes in over this time, so that it is felt as pressing and not as a knock, …
    double gentle_mm = 6.0;    ///< … when its way is no longer than this, …
    double deeper_mm_per_s = 20.0; ///< … and beyond at this speed while it is held
    double liftTime_s = 0.10;
    double stride_mm = 2.0; ///< one step along the screen by keys
};

/// @return settings whose depths suit structures of this size, so that a vessel and a body are both pressed by a share
///         of themselves: the usual 4 mm from 200 mm on. A press reaches through all of it.
[[nodiscard]] PointerHandSettings settingsForSize(double diagonal_mm);

/// Turns a pointer over a surface into what a hand wants: it hovers over the point shown, a press pushes in along the
/// line of sight to the set depth, a drag slides, a release lifts off. The device does the pushing, tick by tick.
///
/// Time comes from the caller, so that the same moves give the same states. While it hovers the device is told that
/// no hand is there (`isPresent` false): a pointer jumps from place to place, and a hand that jumped through tissue
/// would be caught by it.
class PointerHand
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

    /// The pointer's line of sight and the surface point on it, if there is one. A press keeps its depth plane where
    /// the pointer runs off the surface or over the rim of something in front of it.
    /// @param d_W  unit, away from the viewer
    void pointAt(const Vec3& eye_W, const Vec3& d_W, const std::optional<Vec3>& surface_W);
    /// The pointer is elsewhere, or palpation was switched off: lets go at once.
    void goAway();
    void press();
    void release(double now_s);
    /// Changes the depth by notches, within 0 … `deepest_mm`. A notch is `step_mm`, twice that from 20 steps of depth
    /// on, four times from 40, ten times from 100: 0.5 mm, from 10 mm on 1, from 20 mm on 2, from 50 mm on 5.
    /// @return false when that was not all possible
    bool turnDepth(double notches);
    /// Changes the depth by `step_mm` as often as said, wherever it is; otherwise as `turnDepth`.
    bool stepDepth(int steps);
    /// A press goes in as deep as this instead of to the depth that is set; nothing: as set. Within `deepest_mm`, from
    /// where it hovers. [mm]
    void setAim(std::optional<double> depth_mm);

    [[nodiscard]] Phase phase(double now_s) const;
    /// Where the hand hovers; nothing while away. [mm]
    [[nodiscard]] std::optional<Vec3> hoverPoint() const;
    /// What the device is told: it goes in and lifts off by itself, see device/PointerDevice.h. Bit 0 of `buttons` is
    /// the press.
    [[nodiscard]] device::PointerState state(double now_s) const;

    /// What the depth is counted from; nothing while away. [mm]
    [[nodiscard]] const std::optional<Vec3>& surfacePoint() const noexcept { return m_surface_W; }
    /// Unit, the way in.
    [[nodiscard]] const Vec3& direction() const noexcept { return m_d_W; }
    /// How far below the surface that was pointed at a place is, along the line of sight. [mm]
    [[nodiscard]] double pressedDepth_mm(const Vec3& p_W) const;

  private:
    bool setDepth(double depth_mm);

    PointerHandSettings m_settings;
    std::optional<Vec3> m_surface_W; ///< what the depth is counted from
    Vec3 m_d_W = Vec3::UnitZ();
    std::optional<double> m_aim_mm; ///< stands for the depth that is set
    bool m_isDown = false;
    double m_release_s = -1.0; ///< when it was released; < 0: it hovers
};

} // namespace palpate::ui
