// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/StructureModel.h"

#include <palpate/core/Export.h>
#include <palpate/view/SceneView.h>

namespace palpate::ui {

/// Draws moving structures where the hand feels them at a time of the servo loop, from the next frame on. Call together
/// with the cursor of a tick, so that hand, god-object and surface agree.
/// @param time_s  see LiveTouch::timeOf_s
PALPATE_EXPORT void drawMotion(view::SceneView& view, const StructureModel& model, double time_s);

/// Takes a place on moving tissue back to the rest shape, to which lumps, maps and findings refer. [mm]
/// @param motion  null: at rest
[[nodiscard]] PALPATE_EXPORT core::Vec3 restOf(const geometry::SurfaceMotion* motion, double time_s,
                                               const core::Vec3& p_W);

} // namespace palpate::ui
