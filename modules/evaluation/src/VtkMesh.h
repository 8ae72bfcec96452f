// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/TriangleMesh.h>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace palpate::evaluation {

/// The same triangles for VTK, in double precision; cell i is triangle i.
[[nodiscard]] vtkSmartPointer<vtkPolyData> toPolyData(const geometry::TriangleMesh& mesh);

/// A copy with about `share` of the triangles, by quadric error (vtkQuadricDecimation). @param share  0 … 1
[[nodiscard]] geometry::TriangleMesh decimated(const geometry::TriangleMesh& mesh, double share);

} // namespace palpate::evaluation
