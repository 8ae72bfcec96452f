// SPDX-License-Identifier: BSD-3-Clause
#include "labels/LabelSurfaces.h"

#include <palpate/core/Parallel.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDiscreteFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>

namespace palpate::meshio::internal {

namespace {

using core::Vec3;
using geometry::Triangle;
using geometry::TriangleMesh;

/// Copies the bounding box of a label, with one voxel of background around: 1 for its voxels, 0 for all others.
/// @param number  1 + the place in `volume.labels`
vtkSmartPointer<vtkImageData> maskOf(const LabelVolume& volume, std::uint16_t number)
{
    const Label& label = volume.labels[number - std::size_t{1}];
    std::array<int, 3> size{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        size[axis] = static_cast<int>(label.last[axis] - label.first[axis]) + 3;
    }
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(size.data());
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    auto* to = static_cast<std::uint8_t*>(image->GetScalarPointer());
    const auto along = static_cast<std::size_t>(size[0]), rows = static_cast<std::size_t>(size[1]);
    std::fill_n(to, along * rows * static_cast<std::size_t>(size[2]), std::uint8_t{0});
    const std::size_t count = along - 2;
    for (std::size_t k = 0; k + 2 < static_cast<std::size_t>(size[2]); ++k) {
        for (std::size_t j = 0; j + 2 < rows; ++j) {
            const std::size_t from =
                label.first[0] +
                std::size_t{volume.size[0]} *
                    (label.first[1] + j +
                     std::size_t{volume.size[1]} * (label.first[2] + k + std::size_t{volume.size[2]} * label.layer));
            std::transform(volume.voxels.begin() + static_cast<std::ptrdiff_t>(from),
                           volume.voxels.begin() + static_cast<std::ptrdiff_t>(from + count),
                           to + 1 + along * (j + 1 + rows * (k + 1)), [number](std::uint16_t voxel) {
                               return static_cast<std::uint8_t>(voxel == number ? 1 : 0);
                           });
        }
    }
    return image;
}

/// @return six times the enclosed volume, above 0 if the normals point outwards
double signedVolume(const TriangleMesh& mesh)
{
    double sum = 0.0;
    for (const Triangle& t : mesh.triangles) {
        sum += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]]));
    }
    return sum;
}

/// @return the surface of a label in voxels, from the first voxel of the volume
TriangleMesh contourOf(const LabelVolume& volume, std::uint16_t number)
{
    vtkNew<vtkDiscreteFlyingEdges3D> contour;
    contour->SetInputData(maskOf(volume, number));
    contour->SetValue(0, 1.0);
    contour->ComputeScalarsOff();
    contour->ComputeNormalsOff();
    contour->ComputeGradientsOff();
    contour->Update();
    vtkPolyData* const surface = contour->GetOutput();
    TriangleMesh mesh;
    const Label& label = volume.labels[number - std::size_t{1}];
    const Vec3 offset = Vec3(label.first[0], label.first[1], label.first[2]) - Vec3::Ones();
    mesh.vertices.resize(static_cast<std::size_t>(surface->GetNumberOfPoints()));
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        surface->GetPoint(static_cast<vtkIdType>(i), mesh.vertices[i].data());
        mesh.vertices[i] += offset; // multiples of one half, exact in the floats of the filter
    }
    mesh.triangles.reserve(static_cast<std::size_t>(surface->GetNumberOfPolys()));
    const auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
    for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
        vtkIdType corners = 0;
        const vtkIdType* ids = nullptr;
        cells->GetCurrentCell(corners, ids);
        if (corners == 3) {
            mesh.triangles.push_back({static_cast<std::uint32_t>(ids[0]), static_cast<std::uint32_t>(ids[1]),
                                      static_cast<std::uint32_t>(ids[2])});
        }
    }
    return mesh;
}

} // namespace

std::vector<TriangleMesh> labelSurfaces(const LabelVolume& volume, const VolumeLayout& layout,
                                        const std::function<bool(double)>& progress)
{
    std::vector<TriangleMesh> meshes(volume.labels.size());
    const bool isMirrored = layout.steps.determinant() < 0.0;
    std::atomic<bool> isCancelled{false};
    std::atomic<std::size_t> done{0};
    core::parallelFor(meshes.size(), [&](std::size_t i, unsigned thread) {
        if (isCancelled) {
            return;
        }
        TriangleMesh mesh = contourOf(volume, static_cast<std::uint16_t>(i + 1));
        if ((signedVolume(mesh) < 0.0) != isMirrored) {
            geometry::flip(mesh);
        }
        for (Vec3& p : mesh.vertices) {
            p = layout.steps * p + layout.origin;
        }
        meshes[i] = std::move(mesh);
        ++done;
        if (thread == 0 && progress &&
            !progress(static_cast<double>(done.load()) / static_cast<double>(meshes.size()))) {
            isCancelled = true;
        }
    });
    if (isCancelled) {
        meshes.clear();
    }
    return meshes;
}

} // namespace palpate::meshio::internal
