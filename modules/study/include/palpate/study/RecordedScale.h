// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/servo/TickRecord.h>
#include <palpate/session/Recording.h>

namespace palpate::study {

/// Returns the force [N] of a recorded structure's force law at a depth, without maps, buried lumps and damping.
[[nodiscard]] PALPATE_EXPORT double lawForce_N(const session::StructureRecord& on, double depth_mm);

/// Reconstructs the stiffness scale from maps and buried lumps for the contacts of a recorded tick, because recordings
/// do not store the scale s. Solves `s F(d) - b v` along the spring for s. Uses the tissue's own damping b even if a
/// map varies the damping.
/// @param tick  sets `stiffnessScale` of the contacts; 1 without maps
/// @param scene  scene of that tick
/// @param v_WH  velocity of the HIP in that tick [mm/s]
/// @par Cost One table per nonlinear law.
PALPATE_EXPORT void reconstructScales(servo::TickRecord& tick, const session::SceneRecord& scene,
                                      const core::Vec3& v_WH);

} // namespace palpate::study
