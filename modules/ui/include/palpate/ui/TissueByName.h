// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/StructureModel.h"

#include <palpate/core/Export.h>
#include <palpate/study/Layers.h>

#include <vector>

namespace palpate::ui {

/// Derives touch and appearance from structure names (study::namedStiffness_N_per_mm). Healthy tissue gets measured
/// values. A lump gets the published ratio to its organ and keeps its opacity. An organ that contains other structures
/// is translucent. Vessels, nerves and ducts are not palpable as long as another structure is. Structures with an
/// unknown name or their own map are unchanged.
/// @param layering  containment by row; apparent containment in open meshes counts
/// @param first  rows before this one are unchanged
/// @return the changed descriptions
[[nodiscard]] PALPATE_EXPORT std::vector<StructureModel::Edited>
tissueByName(const StructureModel& model, const study::Layering& layering, int first);

} // namespace palpate::ui
