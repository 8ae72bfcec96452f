// SPDX-License-Identifier: BSD-3-Clause
#include "peers/VtkMesh.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkQuadricDecimation.h>

namespace palpate::evaluation {

vtkSmartPointer<vtkPolyData> toPolyData(const geometry::TriangleMesh& mesh)
{
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.vertices.size()));
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        points->SetPoint(static_cast<vtkIdType>(i), mesh.vertices[i].data());
    }
    vtkNew<vtkCellArray> cells;
    for (const geometry::Triangle& t : mesh.triangles) {
        const vtkIdType corners[3]{t[0], t[1], t[2]};
        cells->InsertNextCell(3, corners);
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(cells);
    return data;
}

geometry::TriangleMesh decimated(const geometry::TriangleMesh& mesh, double share)
{
    vtkNew<vtkQuadricDecimation> decimation;
    decimation->SetInputData(toPolyData(mesh));
    decimation->SetTargetReduction(1.0 - share);
    decimation->VolumePreservationOn();
    decimation->Update();
    vtkPolyData* out = decimation->GetOutput();
    geometry::TriangleMesh result;
    for (vtkIdType i = 0; i < out->GetNumberOfPoints(); ++i) {
        geometry::Vec3 p;
        out->GetPoint(i, p.data());
        result.vertices.push_back(p);
    }
    vtkNew<vtkIdList> corners;
    vtkCellArray* cells = out->GetPolys();
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i) {
        cells->GetCellAtId(i, corners);
        if (corners->GetNumberOfIds() == 3) {
            const auto at = [&corners](vtkIdType k) { return static_cast<std::uint32_t>(corners->GetId(k)); };
            result.triangles.push_back({at(0), at(1), at(2)});
        }
    }
    return result;
}

} // namespace palpate::evaluation
