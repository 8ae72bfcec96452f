// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/MeshReport.h>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace palpate::view {

/// Edges whose faces meet at more than this stay sharp. [degrees]
inline constexpr double kFeatureAngle_deg = 60.0;

/// Makes the picture of a surface: points in float, triangles, and smooth point normals that keep feature edges.
/// @param surface  world frame [mm]
/// @par Thread Any; it touches no graphics context. The result belongs to the caller.
[[nodiscard]] vtkSmartPointer<vtkPolyData> makeSurface(const geometry::RepairedMesh& surface);

} // namespace palpate::view
