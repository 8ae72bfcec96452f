// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/TriangleMesh.h>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstddef>

namespace palpate::buried {

[[nodiscard]] vtkSmartPointer<vtkPolyData> toVtk(const geometry::TriangleMesh& mesh);
[[nodiscard]] geometry::TriangleMesh fromVtk(vtkPolyData* data);

/// The same shape with about so many triangles.
[[nodiscard]] geometry::TriangleMesh decimated(const geometry::TriangleMesh& mesh, std::size_t triangles);

/// The same surface with no edge longer than so much: longer ones are halved until they are short enough. Vertices keep
/// their number, new ones follow.
[[nodiscard]] geometry::TriangleMesh refined(const geometry::TriangleMesh& mesh, double longest_mm);

} // namespace palpate::buried
