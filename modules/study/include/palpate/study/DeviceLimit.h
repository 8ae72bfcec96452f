// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/device/HapticDevice.h>
#include <palpate/haptics/HapticScene.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace palpate::study {

/// Returns the largest slope of force over depth on this structure [N/mm].
[[nodiscard]] PALPATE_EXPORT double maxStiffness(const haptics::HapticStructure& structure);
/// Returns the largest damping on this structure [N·s/mm].
[[nodiscard]] PALPATE_EXPORT double maxDamping(const haptics::HapticStructure& structure) noexcept;

/// Returns the largest tissue parameters allowed on a device.
/// @param held_N_per_mm  stiffness that the device can render in scene units, see servo::heldStiffness_N_per_mm;
///               infinite: use 5 N/mm. A device without a stated damping gets 0.02 N·s/mm
[[nodiscard]] PALPATE_EXPORT haptics::Tissue maxTissue(const device::DeviceInfo& info, double held_N_per_mm) noexcept;

/// Reduces the tissues so that the combined stiffness and damping stay within the device's limits.
///
/// A hand that presses through an outer into an inner layer feels both: layers act as springs and dampers in parallel.
/// The upper bound is the sum of the maximum of each layer, independent of position, because a hand in one layer may
/// still hold the god-object of another. The outermost layer takes as much as requested and available; each inner layer
/// gets the rest. A force law below the limit keeps its shape.
/// @param greatest  limits of the device; terms other than stiffness and damping apply to each structure separately
/// @param structures  structures without a surface are ignored
PALPATE_EXPORT void limitTissues(const haptics::Tissue& greatest, std::span<haptics::HapticStructure> structures);

/// Describes the changes made by `limitTissues` in one line, such as "at most 0.4 N/mm of liver (asked for 2 N/mm), at
/// most …". Empty without changes.
/// @param asked,held  before and after
[[nodiscard]] PALPATE_EXPORT std::string limitedText(std::span<const haptics::HapticStructure> asked,
                                                     std::span<const haptics::HapticStructure> held);

/// Part of a device's limit used by all layers except the layer of one structure.
struct UsedByOtherLayers
{
    haptics::Tissue tissue{0.0, 0.0}; ///< sum of stiffness and damping
    std::vector<std::size_t> by;      ///< stiffest structure of each layer, outermost layer first
};
/// @param structures  after `limitTissues`
[[nodiscard]] PALPATE_EXPORT UsedByOtherLayers usedByOtherLayers(std::span<const haptics::HapticStructure> structures,
                                                                 std::size_t structure);

} // namespace palpate::study
