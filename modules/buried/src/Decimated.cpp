// SPDX-License-Identifier: BSD-3-Clause
#include "Decimated.h"

#include <vtkAdaptiveSubdivisionFilter.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkQuadricDecimation.h>

#include <algorithm>
#include <limits>

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

} // namespace

vtkSmartPointer<vtkPolyData> toVtk(const geometry::TriangleMesh& mesh)
{
    const vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.vertices.size()));
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        points->SetPoint(static_cast<vtkIdType>(i), mesh.vertices[i].data());
    }
    const vtkNew<vtkCellArray> cells;
    for (const geometry::Triangle& t : mesh.triangles) {
        cells->InsertNextCell({t[0], t[1], t[2]});
    }
    const auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(cells);
    return data;
}

geometry::TriangleMesh fromVtk(vtkPolyData* data)
{
    geometry::TriangleMesh mesh;
    mesh.vertices.resize(static_cast<std::size_t>(data->GetNumberOfPoints()));
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        data->GetPoint(static_cast<vtkIdType>(i), mesh.vertices[i].data());
    }
    vtkCellArray* cells = data->GetPolys();
    mesh.triangles.reserve(static_cast<std::size_t>(cells->GetNumberOfCells()));
    const vtkNew<vtkIdList> corners;
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i) {
        cells->GetCellAtId(i, corners);
        geometry::Triangle& t = mesh.triangles.emplace_back();
        for (int k = 0; k < 3; ++k) {
            t[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(corners->GetId(k));
        }
    }
    return mesh;
}

geometry::TriangleMesh decimated(const geometry::TriangleMesh& mesh, std::size_t triangles)
{
    const vtkNew<vtkQuadricDecimation> decimation;
    decimation->SetInputData(toVtk(mesh));
    decimation->SetTargetReduction(1.0 - double(triangles) / double(mesh.triangles.size()));
    decimation->VolumePreservationOn();
    decimation->Update();
    return fromVtk(decimation->GetOutput());
}

geometry::TriangleMesh refined(const geometry::TriangleMesh& mesh, double longest_mm)
{
    return fromVtk(subdivided(toVtk(mesh), longest_mm));
}

std::vector<float> refinedValues(const geometry::TriangleMesh& mesh, double longest_mm,
                                 const std::vector<float>& values)
{
    const vtkSmartPointer<vtkPolyData> data = toVtk(mesh);
    const vtkNew<vtkFloatArray> array;
    array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
    std::copy(values.begin(), values.end(), array->Begin());
    data->GetPointData()->SetScalars(array);
    const vtkSmartPointer<vtkPolyData> fine = subdivided(data, longest_mm);
    auto* found = vtkFloatArray::SafeDownCast(fine->GetPointData()->GetScalars());
    return found != nullptr ? std::vector<float>(found->Begin(), found->End()) : values;
}

} // namespace palpate::buried
