// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/StructureModel.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace palpate::ui {

/// How a structure is to be felt.
struct FeltWay
{
    int row = 0;
    std::optional<std::uint32_t> layer; ///< on its own surface, in that layer; nothing: through the organ around it
};

/// Has structures felt so, as one step to undo; nothing when they are already. Lumps that are felt through their organ
/// and not among them stay so. A structure without an organ around it keeps its layer.
/// @param text  what is undone, "Feel below"
void feel(StructureModel& model, const std::vector<FeltWay>& ways, const QString& text);

/// @return the organ that a structure can be felt through: both are closed, and a scene file can name the organ;
/// nothing where there is none.
[[nodiscard]] std::optional<int> organToFeelThrough(const StructureModel& model, int row);

} // namespace palpate::ui
