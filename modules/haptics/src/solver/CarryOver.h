// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/HapticScene.h"
#include "palpate/haptics/PalpatorState.h"

#include <cstdint>
#include <optional>

namespace palpate::haptics::internal {

/// Returns a key that identifies a structure across scenes, a hash of its index and name.
[[nodiscard]] std::uint64_t keyOf(const HapticScene& scene, std::uint32_t structure) noexcept PALPATE_NONBLOCKING;
/// Returns the index of the structure's layer; empty if the structure cannot be touched.
[[nodiscard]] std::optional<std::size_t> layerOf(const HapticScene& scene,
                                                 std::uint64_t key) noexcept PALPATE_NONBLOCKING;

/// Returns true if the god-object touches an open (two-sided) surface.
/// @pre the contacts of `god` belong to `scene`
[[nodiscard]] bool touchesSheet(const HapticScene& scene, const GodObjectState& god) noexcept PALPATE_NONBLOCKING;

/// Returns the contact that a god-object loses because a touched structure can no longer be touched; an invalid contact
/// if there is none.
/// @param before  scene of the contacts
/// @param after  new scene, may be null
/// @param god  state of the god-object
/// @param p_WH  last HIP [mm]
[[nodiscard]] LostContact lostContact(const HapticScene& before, const HapticScene* after, const GodObjectState& god,
                                      const Vec3& p_WH) noexcept PALPATE_NONBLOCKING;

/// Moves a god-object to its new position when surfaces of its layer are replaced.
///
/// The god-object follows the touched triangle, which is identified by its index in the mesh: rigid motion, scaling and
/// shear are followed exactly up to rounding. This requires that, relative to the triangle, the hand is within
/// Palpator::kNear_mm of its previous position, and that the triangle turned by less than 60 degrees. A contact that is
/// still in the same place is not followed.
///
/// After that, the god-object is moved to the nearest position, within 1 mm, that is on its previous side of every
/// surface and keeps the distance it had, up to the fingertip's radius: of replaced surfaces, and of the others once it
/// moves. If there is no such position, the one found with the smallest error is taken. A god-object behind a surface
/// stays there and may leave freely; so does a god-object inside a structure that has no predecessor.
/// @param before,after  the scenes; the predecessor of a structure has the same index and name
/// @param layer  layer of `after`
/// @param god  state of the god-object
/// @param p_WH  last HIP [mm]
/// @return the new position [mm]
/// @par Real-time Wait-free; tests at most kMaxTriangles triangles of each surface, and beyond this limit leaves the
/// god-object in place.
[[nodiscard]] Vec3 carryOverPosition(const HapticScene& before, const HapticScene& after, const HapticLayer& layer,
                                     const GodObjectState& god, const Vec3& p_WH) noexcept PALPATE_NONBLOCKING;

} // namespace palpate::haptics::internal
