// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/vtk/PolyData.h"

#include <palpate/geometry/MeshCheck.h>
#include <palpate/geometry/PolygonCutter.h>

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace palpate::vtk {

using core::Count;
using core::Result;
using core::Status;
using core::StatusCode;
using geometry::PolygonCutter;
using geometry::Triangle;
using geometry::TriangleMesh;

namespace {

Status checkCell(const vtkIdType* corners, vtkIdType count, vtkIdType points, std::size_t cell, bool isStrip)
{
    const vtkIdType most = isStrip ? std::numeric_limits<std::int32_t>::max() : vtkIdType{PolygonCutter::kMostCorners};
    if (count < 3 || count > most) {
        return {StatusCode::BadFormat, PALPATE_TEXT("polygon %1 has %2 corners, expected 3 to %3"), Count(cell), count,
                most};
    }
    for (vtkIdType k = 0; k < count; ++k) {
        if (corners[k] < 0 || corners[k] >= points) {
            return {StatusCode::OutOfRange, PALPATE_TEXT("polygon %1 uses point %2, expected 0 to %3"), Count(cell),
                    corners[k], points - 1};
        }
    }
    return {};
}

void addStrip(const std::vector<std::uint32_t>& corners, std::vector<Triangle>& triangles)
{
    for (std::size_t k = 0; k + 2 < corners.size(); ++k) { // the winding alternates along a strip
        const std::size_t odd = k % 2;
        triangles.push_back({corners[k], corners[k + 1 + odd], corners[k + 2 - odd]});
    }
}

/// Appends the triangles of polygons or strips.
Status addCells(vtkCellArray& cells, bool isStrip, PolygonCutter& cutter, TriangleMesh& mesh)
{
    const auto points = static_cast<vtkIdType>(mesh.vertices.size());
    std::vector<std::uint32_t> polygon;
    std::size_t cell = 0;
    const auto iterator = ::vtk::TakeSmartPointer(cells.NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell(), ++cell) {
        vtkIdType count = 0;
        const vtkIdType* corners = nullptr;
        iterator->GetCurrentCell(count, corners);
        if (Status status = checkCell(corners, count, points, cell, isStrip); !status.isOk()) {
            return status;
        }
        polygon.assign(corners, corners + count);
        if (isStrip) {
            addStrip(polygon, mesh.triangles);
        } else if (count == 3) {
            mesh.triangles.push_back({polygon[0], polygon[1], polygon[2]});
        } else {
            cutter.cut(mesh.vertices, polygon, mesh.triangles);
        }
    }
    return {};
}

} // namespace

Result<TriangleMesh> meshOf(vtkPolyData* data)
{
    if (data == nullptr || data->GetPoints() == nullptr) {
        return Status(StatusCode::Empty,
                      PALPATE_TEXT("found no points, expected a surface; was the filter before it updated?"));
    }
    TriangleMesh mesh;
    mesh.vertices.resize(static_cast<std::size_t>(data->GetNumberOfPoints()));
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        data->GetPoint(static_cast<vtkIdType>(i), mesh.vertices[i].data());
        if (!mesh.vertices[i].allFinite()) { // before polygons are triangulated
            return geometry::check({mesh.vertices, {{0, 0, 0}}}).status();
        }
    }
    PolygonCutter cutter;
    mesh.triangles.reserve(static_cast<std::size_t>(data->GetPolys()->GetNumberOfCells()));
    for (vtkCellArray* cells : {data->GetPolys(), data->GetStrips()}) {
        if (Status status = addCells(*cells, cells == data->GetStrips(), cutter, mesh); !status.isOk()) {
            return status;
        }
    }
    if (const geometry::MeshCheck found = geometry::check(mesh); !found.isOk()) {
        return found.status();
    }
    return mesh;
}

Result<geometry::RepairedMesh> surfaceOf(vtkPolyData* data, const SurfaceOptions& options)
{
    if (!(options.unit_mm > 0.0 && options.unit_mm <= geometry::kMostCoordinate_mm)) {
        return Status(StatusCode::OutOfRange, PALPATE_TEXT("unit_mm: found %1, expected more than 0 and at most %2"),
                      options.unit_mm, geometry::kMostCoordinate_mm);
    }
    Result<TriangleMesh> mesh = meshOf(data);
    if (!mesh.isOk()) {
        return mesh.status();
    }
    for (core::Vec3& p : mesh.value().vertices) {
        p *= options.unit_mm;
    }
    return geometry::surfaceOf(mesh.value(), options.repair);
}

Result<vtkSmartPointer<vtkFloatArray>> atPoints(const geometry::RepairedMesh& surface, std::span<const float> values,
                                                const char* name)
{
    if (values.size() < surface.mesh.vertices.size() || surface.vertexOfSource.empty()) {
        return Status(StatusCode::Mismatch,
                      PALPATE_TEXT("found %1 values for %2 vertices and %3 points, expected one for each vertex of a "
                                   "surface from surfaceOf"),
                      Count(values.size()), Count(surface.mesh.vertices.size()), Count(surface.vertexOfSource.size()));
    }
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetName(name);
    array->SetNumberOfValues(static_cast<vtkIdType>(surface.vertexOfSource.size()));
    for (std::size_t i = 0; i < surface.vertexOfSource.size(); ++i) {
        const std::uint32_t vertex = surface.vertexOfSource[i];
        array->SetValue(static_cast<vtkIdType>(i),
                        vertex == geometry::kNoVertex ? std::numeric_limits<float>::quiet_NaN() : values[vertex]);
    }
    return array;
}

vtkSmartPointer<vtkPolyData> polyDataOf(const TriangleMesh& mesh)
{
    const vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.vertices.size()));
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        points->SetPoint(static_cast<vtkIdType>(i), mesh.vertices[i].data());
    }
    const vtkNew<vtkCellArray> cells;
    for (const Triangle& t : mesh.triangles) {
        cells->InsertNextCell({t[0], t[1], t[2]});
    }
    const auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(cells);
    return data;
}

} // namespace palpate::vtk
