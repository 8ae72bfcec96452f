// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/servo/SafetyGate.h"

#include <palpate/core/Realtime.h>
#include <palpate/core/Types.h>

#include <cstdint>
#include <type_traits>

namespace palpate::servo {

/// How a device's workspace lies in the scene; the window says it, any tick may bring a change.
struct MapSettings
{
    /// D is the world frame, nothing is mapped: mouse, playback, simulated hand. The rest is then without meaning.
    bool isDirect = true;
    core::Quaternion q_WD = core::Quaternion::Identity(); ///< orientation of D in the scene, unit
    double scale = 1.0;                                   ///< mm of the scene a mm of the device, > 0
    Vec3 centre_W = Vec3::Zero();                         ///< where the device's origin goes when it is centred [mm]
    std::uint32_t centreRequest = 0; ///< another value than before: centre now, the hand jumps and begins anew
    bool isClutched = false;         ///< by a key: the device moves, the HIP stays
    std::uint32_t clutchButtons = 0; ///< while one of these is down: the same
    /// Distance of the device from its origin beyond which it is clutched; it stays so until it is back within half of
    /// that. A device that starts out there is not clutched before it has been inside once. 0: no such clutch. [mm]
    double edge_mm = 0.0;
};
static_assert(std::is_trivially_destructible_v<MapSettings>); // crosses threads in a PlainCopy

/// A tick's hand in the scene.
struct MappedInput
{
    Vec3 p_W = Vec3::Zero(); ///< HIP [mm]
    bool isClutched = false; ///< the HIP stands still and nothing is to be felt
    bool isAtEdge = false;   ///< clutched because the device is at its workspace's edge
    bool isReleased = false; ///< the clutch was let go in this tick: force is to be eased in
    bool isMoved = false;    ///< the HIP was put elsewhere: contacts begin anew here
};

/// Carries the HIP from the device's frame D into the scene and forces back:
///   p_W = a_W + s R (p_D - a_D),  f_D = R^T f_W.
/// The anchor (a_D, a_W) is moved whenever s or R change or a clutch is let go, so that the HIP stays where it is and
/// the god-object has nowhere to go: no change pulls it through a surface, and the spring between them keeps its
/// length. Only centring moves the HIP; contacts then begin anew, as for a hand that comes.
///
/// Forces are not scaled: a tissue of k N/mm feels like k s N/mm at the device, and the loop must hold that stably.
/// @par Real-time Wait-free, no allocation. One thread.
class WorkspaceMap
{
  public:
    /// From the next `map` on. Settings that are not finite, a scale outside 1e-6 to 1e6 or a rotation that is none
    /// are ignored.
    void set(const MapSettings& settings) noexcept PALPATE_NONBLOCKING;
    /// @param input  what the gate admitted, with a hand
    [[nodiscard]] MappedInput map(const GatedInput& input, std::uint32_t buttons) noexcept PALPATE_NONBLOCKING;

    [[nodiscard]] Vec3 toDevice(const Vec3& f_W) const noexcept PALPATE_NONBLOCKING;
    [[nodiscard]] Vec3 toScene(const Vec3& f_D) const noexcept PALPATE_NONBLOCKING;
    [[nodiscard]] double scale() const noexcept { return m_used.isDirect ? 1.0 : m_used.scale; }

  private:
    [[nodiscard]] Vec3 placed(const Vec3& p_D) const noexcept;
    void anchor(const Vec3& p_D, const Vec3& p_W) noexcept;

    MapSettings m_used;  // decides where the HIP is
    MapSettings m_asked; // newest
    Eigen::Matrix3d m_R_WD = Eigen::Matrix3d::Identity();
    Vec3 m_a_D = Vec3::Zero();
    Vec3 m_a_W = Vec3::Zero();
    Vec3 m_p_W = Vec3::Zero(); // of the tick before
    bool m_isPlaced = false;   // the anchor means something
    bool m_isClutched = false;
    bool m_isAtEdge = false;
    bool m_wasInside = false; // the edge, since it was centred: an arm that rests beyond it comes as it is mapped
};

/// The scale with which something of this size fills the part of a workspace that the edge leaves free.
/// @param edge_mm  as in MapSettings, > 0
[[nodiscard]] double scaleToFill(double size_mm, double edge_mm) noexcept;

/// Where the device's automatic clutch takes hold: nine tenths of its workspace. [mm]
[[nodiscard]] double edgeOf(const device::DeviceInfo& info) noexcept;

} // namespace palpate::servo
