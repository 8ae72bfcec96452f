// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/meshio/SceneMotion.h"

namespace palpate::meshio::internal {

/// Makes a motion from displacement fields: each is sampled at the vertices of the surfaces that share the motion, and
/// a lattice is fitted to these. The fields are in the patient's coordinates [mm].
/// @return errors name the file, or cell and frame; frame 0 is the rest shape if there are several files
[[nodiscard]] geometry::SurfaceMotion::Made fieldMotion(const SceneMotion& motion, const MotionSubject& subject);

} // namespace palpate::meshio::internal
