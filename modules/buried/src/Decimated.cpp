// SPDX-License-Identifier: BSD-3-Clause
#include "Decimated.h"

#include <palpate/vtk/PolyData.h>

#include <vtkAdaptiveSubdivisionFilter.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace palpate::buried {

namespace {

/// Bisects edges longer than `longest_mm` until all are short enough; point data is interpolated linearly.
vtkSmartPointer<vtkPolyData> subdivided(const vtkSmartPointer<vtkPolyData>& data, double longest_mm)
{
    const vtkNew<vtkAdaptiveSubdivisionFilter> subdivision;
    subdivision->SetInputData(data);
    subdivision->SetMaximumEdgeLength(longest_mm);
    subdivision->SetMaximumTriangleArea(std::numeric_limits<double>::max());
    subdivision->Update();
    return subdivision->GetOutput();
}

/// Converts the output of a filter; an empty mesh if the filter removed all triangles.
geometry::TriangleMesh trianglesOf(vtkPolyData* data)
{
    core::Result<geometry::TriangleMesh> mesh = vtk::meshOf(data);
    return mesh.isOk() ? std::move(mesh).value() : geometry::TriangleMesh();
}

} // namespace

geometry::TriangleMesh decimated(const geometry::TriangleMesh& mesh, std::size_t triangles)
{
    const vtkNew<vtkQuadricDecimation> decimation;
    decimation->SetInputData(vtk::polyDataOf(mesh));
    decimation->SetTargetReduction(1.0 - double(triangles) / double(mesh.triangles.size()));
    decimation->VolumePreservationOn();
    decimation->Update();
    return trianglesOf(decimation->GetOutput());
}

geometry::TriangleMesh refined(const geometry::TriangleMesh& mesh, double longest_mm)
{
    return trianglesOf(subdivided(vtk::polyDataOf(mesh), longest_mm));
}

std::vector<float> refinedValues(const geometry::TriangleMesh& mesh, double longest_mm,
                                 const std::vector<float>& values)
{
    const vtkSmartPointer<vtkPolyData> data = vtk::polyDataOf(mesh);
    const vtkNew<vtkFloatArray> array;
    array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
    std::copy(values.begin(), values.end(), array->Begin());
    data->GetPointData()->SetScalars(array);
    const vtkSmartPointer<vtkPolyData> fine = subdivided(data, longest_mm);
    auto* found = vtkFloatArray::SafeDownCast(fine->GetPointData()->GetScalars());
    return found != nullptr ? std::vector<float>(found->Begin(), found->End()) : values;
}

} // namespace palpate::buried
