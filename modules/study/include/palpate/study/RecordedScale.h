// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/servo/TickRecord.h>
#include <palpate/session/Recording.h>

namespace palpate::study {

/// The force [N] that a recorded structure's own law gives at a depth, without maps, lumps below and damping.
[[nodiscard]] double lawForce_N(const session::StructureRecord& on, double depth_mm);

/// Finds by how much maps and lumps below scaled the laws of what a recorded tick touches, which a recording does not
/// keep: the force along the spring is `s F(d) - b v`, and all but s is known. Where a map varied the damping, the
/// tissue's own is taken for it.
/// @param tick  its contacts' `stiffnessScale` are set; 1 where nothing varied
/// @param scene  that was felt; @param v_WH  velocity of the HIP in that tick [mm/s]
/// @par Cost A table of each law that is not linear.
void findScales(servo::TickRecord& tick, const session::SceneRecord& scene, const core::Vec3& v_WH);

} // namespace palpate::study
