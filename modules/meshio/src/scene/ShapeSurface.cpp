// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/meshio/ShapeSurface.h"

#include <palpate/core/Quantity.h>
#include <palpate/geometry/Holes.h>
#include <palpate/geometry/PnTriangles.h>
#include <palpate/geometry/Reshape.h>

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

namespace palpate::meshio {

namespace {

using core::Vec3;
using geometry::RepairedMesh;

constexpr int kIterations = 20; // as in 3D Slicer's conversion of label maps to closed surfaces

/// Limit on the displacement of a vertex: a box along the axes of the voxels.
struct MoveLimit
{
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    Vec3 half_mm = Vec3::Zero();

    /// @return the displacement, clamped to the limit
    [[nodiscard]] Vec3 limited(const Vec3& move_mm) const
    {
        return axes * (axes.transpose() * move_mm).cwiseMax(-half_mm).cwiseMin(half_mm);
    }
};

double meanEdge_mm(const geometry::TriangleMesh& mesh)
{
    double sum = 0.0;
    for (const geometry::Triangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            sum += (mesh.vertices[t[(k + 1) % 3]] - mesh.vertices[t[k]]).norm();
        }
    }
    return sum / (3.0 * static_cast<double>(std::max<std::size_t>(mesh.triangles.size(), 1)));
}

/// True if the mesh consists of voxel faces: nearly all normals are along the axes. Marching cubes bevels the edges.
bool isOfVoxelFaces(const geometry::TriangleMesh& mesh, const Eigen::Matrix3d& axes)
{
    constexpr double kAlong = 0.99985, kMost = 0.01; // cosine of 1°; share of the area with other normals
    double all = 0.0, oblique = 0.0;
    for (const geometry::Triangle& t : mesh.triangles) {
        const Vec3& a = mesh.vertices[t[0]];
        const Vec3 normal = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
        const double twice = normal.norm();
        all += twice;
        oblique += (axes.transpose() * normal).cwiseAbs().maxCoeff() >= kAlong * twice ? 0.0 : twice;
    }
    return oblique <= kMost * all;
}

MoveLimit limitFor(const geometry::TriangleMesh& mesh, const std::optional<geometry::Staircase>& staircase)
{
    if (staircase) {
        const double voxels = isOfVoxelFaces(mesh, staircase->axes) ? 1.0 : 0.5;
        return {staircase->axes, voxels * staircase->voxel_mm};
    }
    return {Eigen::Matrix3d::Identity(), Vec3::Constant(0.5 * meanEdge_mm(mesh))};
}

/// @param unit_mm  length that becomes 1 in the filter, which computes in floats
vtkSmartPointer<vtkPolyData> polyDataOf(const geometry::TriangleMesh& mesh, const Vec3& origin, double unit_mm)
{
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.vertices.size()));
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const Vec3 p = (mesh.vertices[i] - origin) / unit_mm;
        points->SetPoint(static_cast<vtkIdType>(i), p.data());
    }
    vtkNew<vtkCellArray> cells;
    for (const geometry::Triangle& t : mesh.triangles) {
        const std::array<vtkIdType, 3> ids{t[0], t[1], t[2]};
        cells->InsertNextCell(3, ids.data());
    }
    auto out = vtkSmartPointer<vtkPolyData>::New();
    out->SetPoints(points);
    out->SetPolys(cells);
    return out;
}

/// @return vertex positions after the filter, without the displacement limit
std::vector<Vec3> filtered(const geometry::TriangleMesh& mesh, double smoothing)
{
    const geometry::Box box = mesh.bounds();
    const Vec3 origin = box.center();
    const double unit_mm = std::max(box.sizes().norm(), 1e-300);
    vtkNew<vtkWindowedSincPolyDataFilter> filter;
    filter->SetInputData(polyDataOf(mesh, origin, unit_mm));
    filter->SetNumberOfIterations(kIterations);
    filter->SetPassBand(std::pow(10.0, -4.0 * smoothing));
    filter->BoundarySmoothingOff();
    filter->FeatureEdgeSmoothingOff();
    filter->NonManifoldSmoothingOn();
    filter->NormalizeCoordinatesOn();
    filter->Update();
    vtkPoints* const points = filter->GetOutput()->GetPoints();
    std::vector<Vec3> vertices = mesh.vertices;
    if (points == nullptr || points->GetNumberOfPoints() != static_cast<vtkIdType>(vertices.size())) {
        return vertices;
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        Vec3 p;
        points->GetPoint(static_cast<vtkIdType>(i), p.data());
        if (p.allFinite()) {
            vertices[i] = origin + unit_mm * p;
        }
    }
    return vertices;
}

/// @return the surface with the vertices moved
std::shared_ptr<const RepairedMesh> smoothedSurface(const RepairedMesh& before, const MoveLimit& limit, double strength,
                                                    SurfaceSmoothing& done)
{
    std::vector<Vec3> vertices = filtered(before.mesh, strength);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vec3 move_mm = limit.limited(vertices[i] - before.mesh.vertices[i]);
        vertices[i] = before.mesh.vertices[i] + move_mm;
        done.most_mm = std::max(done.most_mm, move_mm.norm());
    }
    auto smoothed = std::make_shared<const RepairedMesh>(geometry::withVertices(before, std::move(vertices)));
    done.volumeAfter_mm3 = std::abs(smoothed->report.volume_mm3);
    return smoothed;
}

core::Message withdrawnSentence(const std::optional<Vec3>& voxel_mm)
{
    const core::Message reason(PALPATE_TEXT("not smoothed: too small, it would lose more than half of its volume"));
    return voxel_mm ? core::Message(PALPATE_TEXT("surface from a label map of %1 × %2 × %3 mm voxels, %4"),
                                    core::Rounded{voxel_mm->x(), 3}, core::Rounded{voxel_mm->y(), 3},
                                    core::Rounded{voxel_mm->z(), 3}, reason)
                    : reason;
}

} // namespace

core::Message SurfaceSmoothing::sentence() const
{
    if (isWithdrawn) {
        return withdrawnSentence(labelVoxel_mm);
    }
    const core::Rounded most{most_mm, 2};
    const Vec3 voxel_mm = labelVoxel_mm.value_or(Vec3::Zero());
    const core::Rounded x{voxel_mm.x(), 3}, y{voxel_mm.y(), 3}, z{voxel_mm.z(), 3}, by{strength, 3};
    if (!(volumeBefore_mm3 > 0.0)) {
        return labelVoxel_mm
                   ? core::Message(PALPATE_TEXT("surface from a label map of %1 × %2 × %3 mm voxels, smoothed "
                                                "by %4: at most %5 mm from the voxel boundary"),
                                   x, y, z, by, most)
                   : core::Message(PALPATE_TEXT("smoothed: vertices moved by at most %1 mm"), most);
    }
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%+.2f", 100.0 * (volumeAfter_mm3 / volumeBefore_mm3 - 1.0));
    core::MessageArgument change(text.data());
    change.kind = core::MessageArgument::Kind::Number;
    return labelVoxel_mm
               ? core::Message(
                     PALPATE_TEXT("surface from a label map of %1 × %2 × %3 mm voxels, smoothed by %4: volume "
                                  "changed by %5 %, at most %6 mm from the voxel boundary"),
                     x, y, z, by, change, most)
               : core::Message(PALPATE_TEXT("smoothed: vertices moved by at most %1 mm, volume %2 %"), most, change);
}

core::Message SurfaceCurving::message() const
{
    using core::Count;
    if (isRefused) {
        return {
            PALPATE_TEXT("curved facets would be %1 triangles, expected at most %2; the surface is felt and drawn as "
                         "facets"),
            Count(triangles), Count(geometry::PnOptions().mostTriangles)};
    }
    if (triangles == before) {
        return core::Message(PALPATE_TEXT("no facet is curved: all edges are flat or sharp"));
    }
    if (flatTriangles > 0) {
        return {
            PALPATE_TEXT("curved facets: %1 triangles instead of %2; facets kept flat, because they would fold: %3"),
            Count(triangles), Count(before), Count(flatTriangles)};
    }
    return {PALPATE_TEXT("curved facets: %1 triangles instead of %2"), Count(triangles), Count(before)};
}

std::vector<core::Message> shapeSentences(const std::optional<geometry::Staircase>& staircase,
                                          const std::optional<SurfaceSmoothing>& smoothing)
{
    std::vector<core::Message> lines;
    if (staircase && !(staircase->isStated && smoothing)) {
        lines.push_back(staircase->sentence());
    }
    if (smoothing) {
        lines.push_back(smoothing->sentence());
    }
    return lines;
}

namespace {

void smooth(ShapedSurface& out, double smoothing)
{
    const RepairedMesh& before = *out.surface;
    const MoveLimit limit = limitFor(before.mesh, out.staircase);
    SurfaceSmoothing& done = out.smoothing.emplace();
    done.strength = smoothing;
    done.limit_mm = limit.half_mm.maxCoeff();
    done.volumeBefore_mm3 = done.volumeAfter_mm3 = std::abs(before.report.volume_mm3);
    if (out.staircase && out.staircase->isStated) {
        done.labelVoxel_mm = out.staircase->voxel_mm;
    }
    std::shared_ptr<const RepairedMesh> smoothed = smoothedSurface(before, limit, smoothing, done);
    constexpr double kLeastVolume = 0.5;
    if (done.volumeAfter_mm3 < kLeastVolume * done.volumeBefore_mm3) {
        done.isWithdrawn = true;
        done.most_mm = 0.0;
        done.volumeAfter_mm3 = done.volumeBefore_mm3;
    } else {
        out.surface = std::move(smoothed);
    }
}

void curve(ShapedSurface& out, double crease_deg)
{
    geometry::PnOptions options;
    options.crease_deg = crease_deg;
    geometry::PnSurface curved = geometry::pnTriangles(*out.surface, options);
    out.curving = {out.surface->mesh.triangles.size(), curved.triangles, curved.flatTriangles, curved.isRefused};
    if (curved.surface) {
        out.surface = std::make_shared<const RepairedMesh>(std::move(*curved.surface));
    }
}

} // namespace

core::Message HoleClosing::message() const
{
    const core::Rounded across_mm{largest_mm, 3};
    const core::Message area = core::areaText(area_mm2);
    return holes == 1 ? core::Message(PALPATE_TEXT("1 hole of %1 mm closed, %2 of new surface"), across_mm, area)
                      : core::Message(PALPATE_TEXT("%1 holes of up to %2 mm closed, %3 of new surface"), holes,
                                      across_mm, area);
}

ShapedSurface shapeSurface(std::shared_ptr<const RepairedMesh> asRead, const SceneStructure& description,
                           const std::optional<geometry::Staircase>& known)
{
    ShapedSurface out{asRead, known ? known : geometry::findStaircase(asRead->mesh)};
    if (description.closeHoles_mm > 0.0) {
        if (auto closed = geometry::withHolesClosed(*asRead, description.closeHoles_mm)) {
            out.closing = {closed->closed, closed->largest_mm, closed->addedArea_mm2};
            out.surface = std::make_shared<const RepairedMesh>(std::move(closed->surface));
        }
    }
    if (description.outwards) {
        if (std::optional<RepairedMesh> turned = geometry::orientedOutwards(*out.surface)) {
            out.surface = std::make_shared<const RepairedMesh>(std::move(*turned));
        }
    }
    if (isSmoothed(description.surface) && !out.surface->mesh.triangles.empty()) {
        smooth(out, description.smoothing);
    }
    if (isCurved(description.surface) && !out.surface->mesh.triangles.empty()) {
        curve(out, description.crease_deg);
    }
    return out;
}

} // namespace palpate::meshio
