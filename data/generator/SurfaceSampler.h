// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Organ.h"

#include <palpate/geometry/TriangleMesh.h>

namespace palpate::phantom {

/// Triangulates the zero level of a distance, the largest piece of it: closed, normals outwards, well-shaped triangles
/// of about the cell's size, every vertex on the surface.
/// @param box      holds the surface [mm]
/// @param cell_mm  edge of a sampling cell
[[nodiscard]] geometry::TriangleMesh sampleSurface(const Distance& distance, const core::Box& box, double cell_mm);

/// Rounds coordinates to 1/1024 mm, below anything that can be felt: files pack better, and builds whose mathematical
/// functions differ in the last bit give the same mesh.
void roundCoordinates(geometry::TriangleMesh& mesh);

} // namespace palpate::phantom
