// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/TriangleMesh.h>

namespace palpate::evaluation {

/// Returns a closed body with wings and a fin, 100 mm long along y, with outward normals. [mm] Like the space shuttle
/// used by Zilles & Salisbury (IROS 1995), the mesh has 616 triangles. data/paper/shuttle.stl is the same mesh in
/// single precision.
[[nodiscard]] geometry::TriangleMesh paperBody();

} // namespace palpate::evaluation
