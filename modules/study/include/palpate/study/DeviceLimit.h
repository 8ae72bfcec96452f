// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/device/HapticDevice.h>
#include <palpate/haptics/HapticScene.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace palpate::study {

/// @return the largest slope of force by depth that a hand can meet on this structure [N/mm].
[[nodiscard]] double greatestStiffness(const haptics::HapticStructure& structure);
/// @return the largest damping that a hand can meet on it [N·s/mm].
[[nodiscard]] double greatestDamping(const haptics::HapticStructure& structure) noexcept;

/// The most that tissues are given on a device.
/// @param held_N_per_mm  that it holds in the scene, see servo::heldStiffness_N_per_mm; infinite: no bound, and 5 N/mm
///                       are taken. Where it states no damping, 0.02 N·s/mm
[[nodiscard]] haptics::Tissue greatestTissue(const device::DeviceInfo& info, double held_N_per_mm) noexcept;

/// Keeps the sum of what can be met together within what a device holds.
///
/// A hand pressed through an outer layer into an inner one feels both: layers are springs in parallel, and so are their
/// dampers. The most that it can meet is therefore the sum over the layers of the greatest in each, wherever they lie:
/// a hand in one may still hold the god-object of another. The outermost layer gets what it asks for as far as the
/// device holds it, each next one what is left. A law keeps its shape where it is no steeper than that.
/// @param greatest    that the device holds; other terms than stiffness and damping bound each structure alone
/// @param structures  those without a surface count for nothing
void boundBy(const haptics::Tissue& greatest, std::span<haptics::HapticStructure> structures);

/// What `boundBy` changed, in one line: "at most 0.4 N/mm of liver (asked for 2 N/mm), at most …"; empty: nothing.
/// @param asked,held  before and after
[[nodiscard]] std::string boundedText(std::span<const haptics::HapticStructure> asked,
                                      std::span<const haptics::HapticStructure> held);

/// What the layers but that of one structure take of a device's limit.
struct TakenElsewhere
{
    haptics::Tissue tissue{0.0, 0.0}; ///< stiffness and damping, summed
    std::vector<std::size_t> by;      ///< the structure that takes most of the stiffness of each layer, outermost first
};
/// @param structures  as they are felt, from `boundBy`
[[nodiscard]] TakenElsewhere takenElsewhere(std::span<const haptics::HapticStructure> structures,
                                            std::size_t structure);

} // namespace palpate::study
