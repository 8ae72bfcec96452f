// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/StructureModel.h"

#include <palpate/study/Layers.h>

#include <vector>

namespace palpate::ui {

/// How structures are felt and shown by what their names say (study::namedStiffness_N_per_mm): healthy tissue as it was
/// measured, a lump by the published ratio to its organ, and opaque; an organ is translucent when others lie in it; the
/// hand passes through vessels, nerves and ducts while anything else is felt. What no name says stays as it is, as does
/// a structure with a map of its own.
/// @param layering  what lies in what, row by row; seeming to lie in something open counts here
/// @param first  structures before this row are left alone
/// @return those that this changes
[[nodiscard]] std::vector<StructureModel::Edited> tissueByName(const StructureModel& model,
                                                               const study::Layering& layering, int first);

} // namespace palpate::ui
