// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/TriangleMesh.h>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <vector>

namespace palpate::buried {

[[nodiscard]] vtkSmartPointer<vtkPolyData> toVtk(const geometry::TriangleMesh& mesh);
[[nodiscard]] geometry::TriangleMesh fromVtk(vtkPolyData* data);

/// The same shape with about so many triangles.
[[nodiscard]] geometry::TriangleMesh decimated(const geometry::TriangleMesh& mesh, std::size_t triangles);

/// The same surface with no edge longer than so much: longer ones are halved until they are short enough. Vertices keep
/// their number, new ones follow.
[[nodiscard]] geometry::TriangleMesh refined(const geometry::TriangleMesh& mesh, double longest_mm);
/// @param values  one for each vertex of `mesh`
/// @return one for each vertex of the same `refined` surface, linear over each triangle of `mesh`
[[nodiscard]] std::vector<float> refinedValues(const geometry::TriangleMesh& mesh, double longest_mm,
                                               const std::vector<float>& values);

} // namespace palpate::buried
