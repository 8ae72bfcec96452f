// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/TriangleMesh.h"

#include <cstdint>
#include <vector>

namespace palpate::geometry {

/// Welds vertices. The first vertex of each group keeps its position and represents the group: the others are within
/// `within_mm` of it, so that chains of close vertices do not grow.
/// @param within_mm  0: only equal coordinates
/// @param out  receives the representatives in input order
/// @return index in `out` of each vertex
[[nodiscard]] std::vector<std::uint32_t> weld(const std::vector<Vec3>& in, double within_mm, std::vector<Vec3>& out);

} // namespace palpate::geometry
