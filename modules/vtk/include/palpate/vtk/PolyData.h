// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>
#include <palpate/geometry/Repair.h>
#include <palpate/geometry/TriangleMesh.h>

#include <vtkFloatArray.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <span>

/// Conversion between vtkPolyData and Palpate's meshes. VTK has a global namespace of the same name: after `using
/// namespace palpate` write `palpate::vtk::surfaceOf`; within namespace palpate, names of VTK's need a leading `::`.
namespace palpate::vtk {

struct SurfaceOptions
{
    double unit_mm = 1.0;             ///< length of one unit of the data [mm], > 0; 1000 for data in metres
    geometry::RepairOptions repair{}; ///< by default, closed surfaces are turned outwards
};

/// Converts polygons and triangle strips to triangles; vertices and lines are ignored. The vertices are the points in
/// the same order, including points without a polygon. Polygons are triangulated, concave ones too.
/// @param data  may be null
/// @return Empty: null, or no polygon; BadFormat: a polygon with less than 3 or more than
///         geometry::PolygonCutter::kMostCorners corners; OutOfRange or NonFinite: see geometry::check
/// @par Cost O(n). Not for the servo thread.
[[nodiscard]] PALPATE_EXPORT core::Result<geometry::TriangleMesh> meshOf(vtkPolyData* data);

/// Converts a surface for touch: checked, in mm, and repaired. The data need neither be triangulated nor have normals.
///
///     const auto liver = palpate::vtk::surfaceOf(contour->GetOutput());
///     if (!liver.isOk()) {
///         return liver.status();
///     }
///     for (const core::Message& sentence : liver.value().report.sentences()) {
///         std::puts(sentence.english().c_str());
///     }
///
/// @return as `meshOf` and geometry::surfaceOf
/// @par Cost O(n log n). Not for the servo thread.
[[nodiscard]] PALPATE_EXPORT core::Result<geometry::RepairedMesh> surfaceOf(vtkPolyData* data,
                                                                            const SurfaceOptions& options = {});

/// Transfers values at the vertices of a repaired surface to the points that the surface was made from, for example a
/// palpability map (buried::FeltSurface) or a measure.
///
///     data->GetPointData()->AddArray(atPoints(surface, felt.press[0].ratio, "k/k0").value());
///
/// @param surface  from `surfaceOf`
/// @param values  one for each vertex of `surface.mesh`; further values are ignored, such as the values at vertices
/// that
///                feltSurface adds
/// @return one value per point, NaN at points that no triangle uses; Mismatch for too few values or if the surface has
///         no `vertexOfSource`
[[nodiscard]] PALPATE_EXPORT core::Result<vtkSmartPointer<vtkFloatArray>>
atPoints(const geometry::RepairedMesh& surface, std::span<const float> values, const char* name);

/// Converts a mesh to points of double precision and triangles, without arrays.
[[nodiscard]] PALPATE_EXPORT vtkSmartPointer<vtkPolyData> polyDataOf(const geometry::TriangleMesh& mesh);

} // namespace palpate::vtk
