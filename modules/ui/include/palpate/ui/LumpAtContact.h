// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/StructureModel.h"
#include "palpate/ui/TouchReading.h"

#include <palpate/core/Export.h>

#include <optional>

namespace palpate::ui {

/// Buried lump under the place of contact on an organ.
struct LumpAtContact
{
    int row = 0;
    double ratio = 1.0; ///< local stiffness relative to the organ without lumps, k/k0 [1]
};

/// Finds the lump that dominates the response at a place on an organ. Among several transmitted lumps this is the one
/// with the largest share, which decreases with the fourth power of the distance (docs/felt.md).
/// @param organRow  structure in contact
/// @param p_WG  contact on the organ's surface [mm]
/// @param depth_mm  penetration depth
/// @return the lump; empty without a transmitted lump in the organ, for a hidden target of an exercise, or when the
/// change is below 7 %, half of the detection threshold of a trained hand
/// @par Cost O(vertices of the organ). Thread: GUI
[[nodiscard]] PALPATE_EXPORT std::optional<LumpAtContact> lumpAtContact(const StructureModel& model, int organRow,
                                                                        const core::Vec3& p_WG, double depth_mm);

/// Adds that lump to a reading. @param organRow  structure in contact
PALPATE_EXPORT void addLump(const StructureModel& model, int organRow, const core::Vec3& p_WG, TouchReading& reading);

} // namespace palpate::ui
