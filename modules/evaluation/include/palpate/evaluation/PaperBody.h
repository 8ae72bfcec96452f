// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/TriangleMesh.h>

namespace palpate::evaluation {

/// Body with wings and a fin, 100 mm long along y, normals outwards: 616 triangles, as many as the space shuttle has
/// that Zilles & Salisbury (IROS 1995) tried their solver on. data/paper/shuttle.stl is this mesh in single precision.
/// [mm]
[[nodiscard]] geometry::TriangleMesh paperBody();

} // namespace palpate::evaluation
