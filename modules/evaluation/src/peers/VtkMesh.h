// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/TriangleMesh.h>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace palpate::evaluation {

/// Converts a mesh to VTK in double precision; cell i is triangle i.
[[nodiscard]] vtkSmartPointer<vtkPolyData> toPolyData(const geometry::TriangleMesh& mesh);

/// Returns a copy with about `share` (0 to 1) of the triangles, simplified by quadric error (vtkQuadricDecimation).
[[nodiscard]] geometry::TriangleMesh decimated(const geometry::TriangleMesh& mesh, double share);

} // namespace palpate::evaluation
