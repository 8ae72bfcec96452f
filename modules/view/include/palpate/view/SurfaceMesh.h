// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/geometry/Repair.h>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace palpate::view {

/// Feature angle: edges between faces that meet at a greater angle are shaded sharp. [degrees]
inline constexpr double kFeatureAngle_deg = 60.0;

/// Converts a surface to VTK: single-precision points, triangles, and smooth point normals that preserve feature
/// edges.
/// @param surface  world frame [mm]
/// @return data owned by the caller
/// @par Thread Any; uses no graphics context.
[[nodiscard]] PALPATE_EXPORT vtkSmartPointer<vtkPolyData> makeSurface(const geometry::RepairedMesh& surface);

} // namespace palpate::view
