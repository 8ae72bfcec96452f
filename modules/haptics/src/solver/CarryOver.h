// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/HapticScene.h"
#include "palpate/haptics/PalpatorState.h"

#include <cstdint>
#include <optional>

namespace palpate::haptics::internal {

/// Which structure, in any scene that has it: its number and its name together.
[[nodiscard]] std::uint64_t keyOf(const HapticScene& scene, std::uint32_t structure) noexcept PALPATE_NONBLOCKING;
/// @return its layer's position in the scene; nothing where it cannot be felt
[[nodiscard]] std::optional<std::size_t> layerOf(const HapticScene& scene,
                                                 std::uint64_t key) noexcept PALPATE_NONBLOCKING;

/// @return true when the god-object touches a surface without an inside. @pre its contacts are of this scene
[[nodiscard]] bool touchesSheet(const HapticScene& scene, const GodObjectState& god) noexcept PALPATE_NONBLOCKING;

/// The contact that a god-object loses because a structure that it touches cannot be felt any more; not valid where it
/// loses none.
/// @param before  scene of the contacts; @param after  that comes, may be null
/// @param p_WH  last HIP [mm]
[[nodiscard]] LeftContact contactLeft(const HapticScene& before, const HapticScene* after, const GodObjectState& god,
                                      const Vec3& p_WH) noexcept PALPATE_NONBLOCKING;

/// Where a god-object goes on when surfaces of its layer are replaced.
///
/// It rides on the touched triangle, which is found by its number in the mesh: a rigid motion, a scale or a shear takes
/// it along to rounding. That is done while the hand is within Palpator::kNear_mm of where it was as the triangle sees
/// it, and the triangle turned by less than 60 degrees. Then, and where the triangle is not found: a place that the
/// replaced surface would have put behind itself, or a ball into, is moved to the nearest one in front, by at most 1
/// mm. In front is the side that the god-object had of the surface before; a god-object behind it stays and is let out
/// freely, and so is one that a structure without a predecessor appears around.
/// @param before,after  the scenes; a structure's predecessor has its number and name
/// @param layer  of `after`
/// @param p_WH  last HIP [mm]
/// @return the god-object's new place [mm]
/// @par Real-time Wait-free; at most kMostAsked triangles of each surface are asked, beyond that it stays.
[[nodiscard]] Vec3 carriedOver(const HapticScene& before, const HapticScene& after, const HapticLayer& layer,
                               const GodObjectState& god, const Vec3& p_WH) noexcept PALPATE_NONBLOCKING;

} // namespace palpate::haptics::internal
