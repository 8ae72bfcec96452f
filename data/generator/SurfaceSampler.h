// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Organ.h"

#include <palpate/geometry/TriangleMesh.h>

namespace palpate::phantom {

/// Triangulates the largest component of the zero level of a distance function. The mesh is closed, with outward
/// normals, well-shaped triangles of about the cell size and all vertices on the surface.
/// @param box   encloses the surface [mm]
/// @param cell_mm  edge of a sampling cell
[[nodiscard]] geometry::TriangleMesh sampleSurface(const Distance& distance, const core::Box& box, double cell_mm);

/// Rounds coordinates to 1/1024 mm, far below anything palpable. Files compress better, and builds whose mathematical
/// functions differ in the last bit give the same mesh.
void roundCoordinates(geometry::TriangleMesh& mesh);

} // namespace palpate::phantom
