// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/TriangleMesh.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace palpate::geometry {

/// Transfers arrays to a welded mesh: each new vertex gets the mean of the known values.
/// @param weldedTo  new index of each vertex of `input`, below `vertices`
/// @param mixed  incremented for each merged value with inputs more than 10 % apart
[[nodiscard]] std::vector<MeshArray> weldArrays(const std::vector<MeshArray>& input,
                                                std::span<const std::uint32_t> weldedTo, std::size_t vertices,
                                                std::size_t& mixed);

/// Keeps only the array values of these triangles. @param source  previous index of each kept triangle, ascending
void keepTriangles(std::vector<MeshArray>& arrays, std::span<const std::uint32_t> source);

} // namespace palpate::geometry
