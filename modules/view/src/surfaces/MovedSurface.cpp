// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/MovedSurface.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace palpate::view {

namespace {

using core::Vec3;
using geometry::SurfaceMotion;

vtkSmartPointer<vtkFloatArray> arrayLike(vtkFloatArray& other)
{
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetName(other.GetName());
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(other.GetNumberOfTuples());
    return array;
}

} // namespace

MovedSurface movedSurface(std::shared_ptr<const SurfaceMotion> motion, double time_s,
                          const vtkSmartPointer<vtkFloatArray>& points, const vtkSmartPointer<vtkFloatArray>& normals)
{
    MovedSurface moved{motion, motion->at(time_s), arrayLike(*points), arrayLike(*normals)};
    const float *p = points->GetPointer(0), *n = normals->GetPointer(0);
    float *pTo = moved.points->GetPointer(0), *nTo = moved.normals->GetPointer(0);
    geometry::Mat3 F;
    for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i, p += 3, n += 3, pTo += 3, nTo += 3) {
        const Vec3 place = motion->toWorld(moved.moment, Vec3(p[0], p[1], p[2]), F);
        // The cofactors of F are det F times F⁻ᵀ, and det F > 0.
        const Vec3 turned = double{n[0]} * F.col(1).cross(F.col(2)) + double{n[1]} * F.col(2).cross(F.col(0)) +
                            double{n[2]} * F.col(0).cross(F.col(1));
        const Vec3 normal = turned.normalized();
        for (int axis = 0; axis < 3; ++axis) {
            pTo[axis] = static_cast<float>(place[axis]);
            nTo[axis] = static_cast<float>(normal[axis]);
        }
    }
    return moved;
}

bool isSamePlace(const SurfaceMotion::Moment& a, const SurfaceMotion::Moment& b) noexcept
{
    const auto used = static_cast<std::ptrdiff_t>(a.frames);
    return a.frames == b.frames && a.shift == b.shift && a.turn == b.turn &&
           std::equal(a.frame.begin(), a.frame.begin() + used, b.frame.begin()) &&
           std::equal(a.weight.begin(), a.weight.begin() + used, b.weight.begin());
}

} // namespace palpate::view
