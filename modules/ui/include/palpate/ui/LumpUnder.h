// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/StructureModel.h"

#include <optional>

namespace palpate::ui {

/// A lump that is felt through the place where its organ is touched.
struct LumpUnder
{
    int row = 0;
    double ratio = 1.0; ///< stiffness there by that of the organ without lumps, k/k0 [1]
};

/// Finds the lump that changes what the hand feels of an organ at a place. Of several that are felt through the organ
/// the one with the largest share there, which falls with the fourth power of the distance (resources/docs/felt.md).
/// @param organRow  the structure that is touched; @param p_WG  on it [mm]; @param depth_mm  of the hand in it
/// @return nothing where no lump is felt through the organ, or the change is below 7 %, half of what a trained hand
/// tells
/// @par Cost of one look at each of the organ's vertices. Thread: the GUI's
[[nodiscard]] std::optional<LumpUnder> lumpUnder(const StructureModel& model, int organRow, const core::Vec3& p_WG,
                                                 double depth_mm);

} // namespace palpate::ui
