// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/Repair.h"

#include <palpate/core/Export.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace palpate::geometry {

/// Reverses inside-out closed components (MeshReport::insideOutComponents) so that they face outwards, together with
/// all closed components inside them, whose cavities remain cavities. Other components are unchanged.
/// @param surface  result of `repair`
/// @return std::nullopt if no component is inside out
/// @par Cost As `repair`. Any thread.
[[nodiscard]] PALPATE_EXPORT std::optional<RepairedMesh> orientedOutwards(const RepairedMesh& surface);

/// Moves the vertices of a repaired surface and repairs the result, because vertices may coincide after the move.
/// `source` and `turned` still refer to the mesh that `surface` was repaired from, and the report keeps the counts of
/// that first repair.
/// @param vertices  new positions, one for each vertex of `surface` [mm], finite
/// @par Cost As `repair`. Any thread.
[[nodiscard]] PALPATE_EXPORT RepairedMesh withVertices(const RepairedMesh& surface, std::vector<Vec3> vertices);

/// Replaces the triangles of a repaired surface by others that lie on the same surface, for example by a subdivision,
/// and repairs the result. `source`, `turned` and the report are as for `withVertices`, but the corners of a triangle
/// are no longer those of its source.
/// @param parents  for each triangle of `mesh` the triangle of `surface` that it belongs to
/// @par Cost As `repair`. Any thread.
[[nodiscard]] PALPATE_EXPORT RepairedMesh withTriangles(const RepairedMesh& surface, const TriangleMesh& mesh,
                                                        const std::vector<std::uint32_t>& parents);

} // namespace palpate::geometry
