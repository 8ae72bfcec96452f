// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/StructureModel.h"

#include <palpate/core/Export.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace palpate::ui {

/// Touch mode of a structure: own surface in a layer, or transmitted through the surrounding organ.
struct TouchMode
{
    int row = 0;
    /// Layer of the structure's own surface; empty: transmitted through the surrounding organ.
    std::optional<std::uint32_t> layer;
};

/// Applies touch modes as one undo step, or does nothing when they already apply. Other transmitted lumps keep their
/// mode. A structure without a surrounding organ keeps its layer.
/// @param text  label of the undo step, "Feel below"
PALPATE_EXPORT void feel(StructureModel& model, const std::vector<TouchMode>& ways, const QString& text);

/// Organ through which a structure can be felt, or empty. Both meshes must be closed, and the organ's name must be
/// unique because a scene file refers to organs by name.
[[nodiscard]] PALPATE_EXPORT std::optional<int> transmittingOrgan(const StructureModel& model, int row);

} // namespace palpate::ui
