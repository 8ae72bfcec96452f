// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/servo/SafetyGate.h"

#include <palpate/core/Export.h>
#include <palpate/core/Realtime.h>
#include <palpate/core/Types.h>

#include <cstdint>
#include <type_traits>

namespace palpate::servo {

/// Mapping of a device workspace to the scene. Set by the window; may change in any tick.
struct MapSettings
{
    /// D equals the world frame, without mapping: mouse, playback, simulated hand. All other fields are then ignored.
    bool isDirect = true;
    core::Quaternion q_WD = core::Quaternion::Identity(); ///< orientation of D in the scene, unit
    double scale = 1.0;                                   ///< scene mm per device mm, > 0
    Vec3 centre_W = Vec3::Zero();                         ///< target of the device origin on centring [mm]
    std::uint32_t centreRequest = 0; ///< a changed value centres now: the HIP jumps and contacts restart
    bool isClutched = false;         ///< clutched by a key: the device moves, the HIP stays
    std::uint32_t clutchButtons = 0; ///< clutched while any of these buttons is down
    /// Distance of the device from its origin at which the edge clutch engages; releases within half of this distance.
    /// A device that starts outside is not clutched until it has been inside once. 0: no edge clutch [mm]
    double edge_mm = 0.0;
};
static_assert(std::is_trivially_destructible_v<MapSettings>); // crosses threads in a PlainCopy

/// Input of a tick in the scene.
struct MappedInput
{
    Vec3 p_W = Vec3::Zero(); ///< HIP [mm]
    bool isClutched = false; ///< the HIP stands still and nothing is to be felt
    bool isAtEdge = false;   ///< clutched because the device is at the edge of its workspace
    bool isReleased = false; ///< the clutch was released in this tick: ease the force in
    bool isMoved = false;    ///< the HIP was repositioned: contacts restart here
};

/// Maps the HIP from the device frame D to the scene, and forces back:
///   p_W = a_W + s R (p_D - a_D),  f_D = R^T f_W.
/// Each change of s or R and each clutch release moves the anchor (a_D, a_W) so that the HIP stays in place. No change
/// can therefore pull the god-object through a surface, and the virtual coupling keeps its length. Only centring moves
/// the HIP; contacts then restart, as for a new hand.
///
/// Forces are not scaled: a tissue of k N/mm has k s N/mm at the device, and the loop must be stable at this stiffness.
/// @par Real-time Wait-free, no allocation. One thread.
class PALPATE_EXPORT WorkspaceMap
{
  public:
    /// Applies from the next `map` on. Ignores non-finite settings, a scale outside 1e-6 to 1e6, and invalid rotations.
    void set(const MapSettings& settings) noexcept PALPATE_NONBLOCKING;
    /// @param input  output of the gate, with a hand
    [[nodiscard]] MappedInput map(const GatedInput& input, std::uint32_t buttons) noexcept PALPATE_NONBLOCKING;

    [[nodiscard]] Vec3 toDevice(const Vec3& f_W) const noexcept PALPATE_NONBLOCKING;
    [[nodiscard]] Vec3 toScene(const Vec3& f_D) const noexcept PALPATE_NONBLOCKING;
    [[nodiscard]] double scale() const noexcept { return m_used.isDirect ? 1.0 : m_used.scale; }

  private:
    [[nodiscard]] Vec3 placed(const Vec3& p_D) const noexcept;
    void anchor(const Vec3& p_D, const Vec3& p_W) noexcept;

    MapSettings m_used;  // settings in effect
    MapSettings m_asked; // most recent request
    Eigen::Matrix3d m_R_WD = Eigen::Matrix3d::Identity();
    Vec3 m_a_D = Vec3::Zero();
    Vec3 m_a_W = Vec3::Zero();
    Vec3 m_p_W = Vec3::Zero(); // of the previous tick
    bool m_isPlaced = false;   // the anchor is valid
    bool m_isClutched = false;
    bool m_isAtEdge = false;
    bool m_wasInside = false; // inside the edge since centring; until then the edge clutch stays off
};

/// Scale at which an object of this size fills the workspace within the edge.
/// @param edge_mm  as in MapSettings, > 0
[[nodiscard]] PALPATE_EXPORT double scaleToFill(double size_mm, double edge_mm) noexcept;

/// Distance of the automatic edge clutch: 90 % of the workspace [mm].
[[nodiscard]] PALPATE_EXPORT double edgeOf(const device::DeviceInfo& info) noexcept;

} // namespace palpate::servo
