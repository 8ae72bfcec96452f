// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>
#include <palpate/device/HapticDevice.h>

#include <cstdint>
#include <optional>

namespace palpate::ui {

using core::Vec3;

/// How a hand that is a mouse or pen feels.
struct PointerHandSettings
{
    double hover_mm = 2.0;     ///< gap to the surface while nothing is pressed
    double depth_mm = 4.0;     ///< how far a press goes in
    double step_mm = 0.5;      ///< one notch of the wheel
    double deepest_mm = 30.0;  ///< the wheel stops here
    double pressTime_s = 0.15; ///< a press goes in over this time, so that it is felt as pressing and not as a knock
    double liftTime_s = 0.10;
};

/// @return settings whose depths suit structures of this size, so that a vessel and a body are both pressed by a share
///         of themselves: the usual 4 mm from 200 mm on.
[[nodiscard]] PointerHandSettings settingsForSize(double diagonal_mm);

/// Turns a pointer over a surface into the HIP of a hand: it hovers over the point shown, a press pushes in along the
/// line of sight to the set depth, a drag slides, a release lifts off.
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
    /// The device's first tick with this hand was felt: a press may go in. Until then it waits where it hovers, because
    /// a hand that appears inside tissue would start there, feeling nothing.
    void land(double now_s);
    /// The pointer is elsewhere, or palpation was switched off: lets go at once.
    void goAway();
    void press(double now_s);
    void release(double now_s);
    /// Changes the depth by notches, within 0 … `deepest_mm`.
    void turnDepth(double steps);

    [[nodiscard]] Phase phase(double now_s) const;
    /// How far in the hand is now, of the set depth: 0 … 1.
    [[nodiscard]] double pressed(double now_s) const;
    /// True while the HIP changes without the pointer moving.
    [[nodiscard]] bool isMoving(double now_s) const;
    /// HIP; nothing while away. [mm]
    [[nodiscard]] std::optional<Vec3> hip(double now_s) const;
    /// What the device reads; `buttons` bit 0 is the press.
    /// @param time_ns  monotonic, stamped into the state
    [[nodiscard]] device::DeviceState state(double now_s, std::int64_t time_ns) const;

  private:
    PointerHandSettings m_settings;
    std::optional<Vec3> m_surface_W; ///< what the depth is counted from
    Vec3 m_d_W = Vec3::UnitZ();
    bool m_isDown = false;
    bool m_isLanded = false; ///< the device has felt the hand since it came
    double m_change_s = 0.0; ///< when it was pressed or released last
    double m_atChange = 0.0; ///< share of the way in at that time
};

} // namespace palpate::ui
