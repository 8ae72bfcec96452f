// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/CoarseSurface.h"

#include <palpate/core/Types.h>

#include <Eigen/Geometry>

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace palpate::view {

namespace {

using core::Vec3;

constexpr double kLargestGrid = 1 << 20;

/// Cluster of the points in a cell.
struct Cluster
{
    Vec3 sum = Vec3::Zero(), normal = Vec3::Zero();
    double count = 0.0;
};

double areaOf(vtkPolyData& surface)
{
    double area = 0.0, p[3][3];
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    const auto cells = vtk::TakeSmartPointer(surface.GetPolys()->NewIterator());
    for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
        cells->GetCurrentCell(count, corners);
        for (int i = 0; i < 3; ++i) {
            surface.GetPoints()->GetPoint(corners[i], p[i]);
        }
        const Vec3 a(p[0]), b(p[1]), c(p[2]);
        area += 0.5 * (b - a).cross(c - a).norm();
    }
    return area;
}

/// Numbers the cells of a grid that have points, once for each octant of the normals. @return cluster of each point
std::vector<std::int32_t> clustersOf(vtkPolyData& surface, double width, std::vector<Cluster>& clusters)
{
    vtkPoints& points = *surface.GetPoints();
    vtkDataArray* normals = surface.GetPointData()->GetNormals();
    const double* bounds = surface.GetBounds();
    const Vec3 low(bounds[0], bounds[2], bounds[4]);
    std::unordered_map<std::uint64_t, std::int32_t> numbers;
    numbers.reserve(static_cast<std::size_t>(points.GetNumberOfPoints() / 4 + 1));
    std::vector<std::int32_t> of(static_cast<std::size_t>(points.GetNumberOfPoints()));
    for (vtkIdType i = 0; i < points.GetNumberOfPoints(); ++i) {
        double p[3] = {0.0, 0.0, 0.0}, n[3] = {0.0, 0.0, 0.0};
        points.GetPoint(i, p);
        if (normals != nullptr) {
            normals->GetTuple(i, n);
        }
        std::uint64_t cell = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double at = std::clamp((p[axis] - low[axis]) / width, 0.0, kLargestGrid - 1.0);
            cell = (cell << 20U) | static_cast<std::uint64_t>(at);
        }
        // By octant of the normal too: the two sides of a thin bone would become one, with holes and without a normal.
        for (const double component : n) {
            cell = (cell << 1U) | static_cast<std::uint64_t>(component < 0.0);
        }
        const auto [number, isNew] = numbers.emplace(cell, static_cast<std::int32_t>(clusters.size()));
        if (isNew) {
            clusters.emplace_back();
        }
        Cluster& cluster = clusters[static_cast<std::size_t>(number->second)];
        cluster.sum += Vec3(p);
        cluster.normal += Vec3(n);
        cluster.count += 1.0;
        of[static_cast<std::size_t>(i)] = number->second;
    }
    return of;
}

} // namespace

vtkSmartPointer<vtkPolyData> coarseSurface(vtkPolyData& surface, double divisor)
{
    auto coarse = vtkSmartPointer<vtkPolyData>::New();
    const vtkIdType triangles = surface.GetNumberOfPolys();
    const double area = areaOf(surface);
    if (triangles == 0 || !(area > 0.0) || !std::isfinite(area)) {
        return coarse;
    }
    // A surface has about two triangles for each cell that it passes.
    std::vector<Cluster> clusters;
    const std::vector<std::int32_t> of =
        clustersOf(surface, std::sqrt(2.0 * divisor * area / static_cast<double>(triangles)), clusters);
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    for (const Cluster& cluster : clusters) {
        points->InsertNextPoint(Vec3(cluster.sum / cluster.count).data());
        normals->InsertNextTuple(Vec3(cluster.normal.stableNormalized()).data());
    }
    vtkNew<vtkCellArray> cells;
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    const auto fine = vtk::TakeSmartPointer(surface.GetPolys()->NewIterator());
    for (fine->GoToFirstCell(); !fine->IsDoneWithTraversal(); fine->GoToNextCell()) {
        fine->GetCurrentCell(count, corners);
        vtkIdType t[3];
        for (int i = 0; i < 3; ++i) {
            t[i] = of[static_cast<std::size_t>(corners[i])];
        }
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) {
            cells->InsertNextCell(3, t);
        }
    }
    coarse->SetPoints(points);
    coarse->SetPolys(cells);
    coarse->GetPointData()->SetNormals(normals);
    return coarse;
}

void CoarseSurfaces::start(const std::vector<vtkSmartPointer<vtkPolyData>>& surfaces, double divisor)
{
    if (isBusy()) {
        return;
    }
    std::vector<Pair>
        jobs; // the second is a shallow copy first, because reading an object of VTK may change its caches
    for (const auto& surface : surfaces) {
        if (surface->GetNumberOfPolys() >= kLeastTriangles) {
            auto copy = vtkSmartPointer<vtkPolyData>::New();
            copy->ShallowCopy(surface);
            jobs.emplace_back(surface, copy);
        }
    }
    m_made = std::async(std::launch::async, [jobs = std::move(jobs), divisor]() mutable {
        for (Pair& job : jobs) {
            job.second = coarseSurface(*job.second, divisor);
        }
        return std::move(jobs);
    });
}

std::vector<CoarseSurfaces::Pair> CoarseSurfaces::take()
{
    const bool isReady = m_made.valid() && m_made.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    return isReady ? m_made.get() : std::vector<Pair>();
}

} // namespace palpate::view
