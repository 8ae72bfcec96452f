// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/TriangleMesh.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace palpate::geometry {

/// The arrays of a mesh whose vertices are welded: the mean of the values that are known at each.
/// @param weldedTo  for each vertex of `input` its new number, below `vertices`
/// @param mixed  counts the values that differed by more than 10 % at one place
[[nodiscard]] std::vector<MeshArray> weldArrays(const std::vector<MeshArray>& input,
                                                std::span<const std::uint32_t> weldedTo, std::size_t vertices,
                                                std::size_t& mixed);

/// Leaves the arrays' values for these triangles alone. @param source  for each that is kept its number before
void keepTriangles(std::vector<MeshArray>& arrays, std::span<const std::uint32_t> source);

} // namespace palpate::geometry
