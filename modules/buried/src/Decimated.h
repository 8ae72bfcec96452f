// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/TriangleMesh.h>

#include <cstddef>
#include <vector>

namespace palpate::buried {

/// Decimates a mesh to about the given number of triangles.
[[nodiscard]] geometry::TriangleMesh decimated(const geometry::TriangleMesh& mesh, std::size_t triangles);

/// Subdivides all edges longer than `longest_mm` by repeated bisection. Existing vertices keep their index; new ones
/// are appended.
[[nodiscard]] geometry::TriangleMesh refined(const geometry::TriangleMesh& mesh, double longest_mm);
/// @param values  one value for each vertex of `mesh`
/// @return one value for each vertex of the `refined` surface, interpolated linearly over the triangles of `mesh`
[[nodiscard]] std::vector<float> refinedValues(const geometry::TriangleMesh& mesh, double longest_mm,
                                               const std::vector<float>& values);

} // namespace palpate::buried
