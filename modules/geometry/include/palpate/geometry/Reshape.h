// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/MeshReport.h"

#include <optional>
#include <vector>

namespace palpate::geometry {

/// Turns the closed parts that are inside out (MeshReport::insideOutComponents) so that they face outwards, each with
/// all closed parts within it, whose cavities stay cavities. Other parts stay as they are.
/// @param surface  from `repair`
/// @return nothing where no part is inside out
/// @par Cost that of `repair`. Any thread.
[[nodiscard]] std::optional<RepairedMesh> turnedOutwards(const RepairedMesh& surface);

/// Moves the vertices of a repaired surface and repairs it again, as vertices may have come together. `source` and
/// `turned` refer to the mesh that `surface` was repaired from, and what was changed in it is still counted.
/// @param vertices  one for each vertex of `surface` [mm], finite
/// @par Cost that of `repair`. Any thread.
[[nodiscard]] RepairedMesh withVertices(const RepairedMesh& surface, std::vector<Vec3> vertices);

} // namespace palpate::geometry
