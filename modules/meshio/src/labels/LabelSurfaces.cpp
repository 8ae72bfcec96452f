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
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace palpate::meshio::internal {

namespace {

using core::Vec3;
using geometry::Triangle;
using geometry::TriangleMesh;

enum Mask : std::uint8_t
{
    kNone,  ///< background
    kOwn,   ///< the label itself
    kOther, ///< another label
    kSeen   ///< another label, in a part that was followed
};

/// Copies the bounding box of a label, with one voxel of background around, as Mask.
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
                               return voxel == number ? kOwn : voxel == 0 ? kNone : kOther;
                           });
        }
    }
    return image;
}

/// Connected voxels that were given another value.
struct Part
{
    std::uint64_t voxels = 0;
    bool isEnclosed = true; ///< no face is next to background
};

/// Gives all voxels that are connected with one over faces, and have the same value, another value. Keeps the front
/// only, which is much smaller than the part.
/// @param mask  with background around
/// @param to  another value than that of the voxel
Part replacePart(std::uint8_t* mask, const std::array<std::ptrdiff_t, 6>& neighbours, std::ptrdiff_t start,
                 std::uint8_t to)
{
    const std::uint8_t from = mask[start];
    Part part;
    std::vector<std::ptrdiff_t> front{start}, next;
    mask[start] = to;
    for (; !front.empty(); front.swap(next), next.clear()) {
        part.voxels += front.size();
        for (const std::ptrdiff_t voxel : front) {
            for (const std::ptrdiff_t step : neighbours) {
                std::uint8_t& beside = mask[voxel + step];
                part.isEnclosed = part.isEnclosed && beside != kNone;
                if (beside == from) {
                    beside = to;
                    next.push_back(voxel + step);
                }
            }
        }
    }
    return part;
}

/// Adds the parts of other labels that the label encloses: those that touch neither background nor the border of the
/// box over a face. The voxels of all other parts become background.
/// @return the number of voxels added
std::uint64_t addEnclosed(vtkImageData& image)
{
    auto* const mask = static_cast<std::uint8_t*>(image.GetScalarPointer());
    const int* const size = image.GetDimensions();
    const std::ptrdiff_t row = size[0], slice = row * size[1], all = slice * size[2];
    const std::array<std::ptrdiff_t, 6> neighbours{1, -1, row, -row, slice, -slice};
    std::uint64_t added = 0;
    for (std::ptrdiff_t voxel = 0; voxel < all; ++voxel) {
        if (mask[voxel] == kOther) {
            const Part part = replacePart(mask, neighbours, voxel, kSeen);
            if (part.isEnclosed) {
                added += replacePart(mask, neighbours, voxel, kOwn).voxels;
            }
        }
    }
    std::replace(mask, mask + all, std::uint8_t{kSeen}, std::uint8_t{kNone});
    return added;
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
LabelSurface contourOf(const LabelVolume& volume, std::uint16_t number)
{
    LabelSurface out;
    TriangleMesh& mesh = out.mesh;
    const auto mask = maskOf(volume, number);
    out.enclosedVoxels = addEnclosed(*mask);
    vtkNew<vtkDiscreteFlyingEdges3D> contour;
    contour->SetInputData(mask);
    contour->SetValue(0, kOwn);
    contour->ComputeScalarsOff();
    contour->ComputeNormalsOff();
    contour->ComputeGradientsOff();
    contour->Update();
    vtkPolyData* const surface = contour->GetOutput();
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
    return out;
}

/// Passes on surfaces that are made in any order, by several threads, in the order of the labels.
class InOrder
{
  public:
    explicit InOrder(std::size_t count)
        : m_made(count)
    {
    }
    void add(std::size_t i, LabelSurface surface)
    {
        const std::scoped_lock lock(m_mutex);
        m_made[i] = std::move(surface);
        ++m_count;
    }
    [[nodiscard]] double share() const
    {
        const std::scoped_lock lock(m_mutex);
        return static_cast<double>(m_count) / static_cast<double>(m_made.size());
    }
    /// Passes on the next complete surfaces. One thread only. @return the first error of `take`
    core::Status pass(const std::function<core::Status(std::size_t, LabelSurface)>& take)
    {
        while (std::optional<LabelSurface> surface = next()) {
            if (core::Status status = take(m_passed++, *std::move(surface)); !status.isOk()) {
                return status;
            }
        }
        return {};
    }

  private:
    std::optional<LabelSurface> next()
    {
        const std::scoped_lock lock(m_mutex);
        return m_passed < m_made.size() ? std::exchange(m_made[m_passed], std::nullopt) : std::nullopt;
    }

    mutable std::mutex m_mutex;
    std::vector<std::optional<LabelSurface>> m_made;
    std::size_t m_count = 0;
    std::size_t m_passed = 0;
};

} // namespace

core::Result<bool> labelSurfaces(const LabelVolume& volume, const VolumeLayout& layout,
                                 const std::function<core::Status(std::size_t, LabelSurface)>& take,
                                 const std::function<bool(double)>& progress)
{
    InOrder surfaces(volume.labels.size());
    const bool isMirrored = layout.steps.determinant() < 0.0;
    std::atomic<bool> isStopped{false};
    core::Status status;
    core::parallelFor(volume.labels.size(), [&](std::size_t i, unsigned thread) {
        if (isStopped) {
            return;
        }
        LabelSurface surface = contourOf(volume, static_cast<std::uint16_t>(i + 1));
        TriangleMesh& mesh = surface.mesh;
        if ((signedVolume(mesh) < 0.0) != isMirrored) {
            geometry::flip(mesh);
        }
        for (Vec3& p : mesh.vertices) {
            p = layout.steps * p + layout.origin;
        }
        surfaces.add(i, std::move(surface));
        if (thread == 0) {
            status = surfaces.pass(take);
            isStopped = !status.isOk() || (progress && !progress(surfaces.share()));
        }
    });
    if (!isStopped) {
        status = surfaces.pass(take);
    }
    return status.isOk() ? core::Result<bool>(!isStopped) : core::Result<bool>(status);
}

} // namespace palpate::meshio::internal
