// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/geometry/SurfaceMotion.h>

#include <vtkFloatArray.h>
#include <vtkSmartPointer.h>

#include <memory>

namespace palpate::view {

/// Picture of a moving structure at a moment: the vertices are at φ(X, t), where the hand feels them, and the normals
/// are those of the moved surface, F⁻ᵀ n, with F = ∂φ/∂X (resources/docs/motion.md).
struct MovedSurface
{
    std::shared_ptr<const geometry::SurfaceMotion> motion; ///< null: at rest, without the other members
    geometry::SurfaceMotion::Moment moment{};
    vtkSmartPointer<vtkFloatArray> points, normals;
};

/// Moves the picture of a rest shape.
/// @param points,normals  of the rest shape; not changed
/// @par Thread Any
/// @par Cost 0.1 to 0.3 µs per vertex
[[nodiscard]] PALPATE_EXPORT MovedSurface movedSurface(std::shared_ptr<const geometry::SurfaceMotion> motion,
                                                       double time_s, const vtkSmartPointer<vtkFloatArray>& points,
                                                       const vtkSmartPointer<vtkFloatArray>& normals);

/// Returns whether two moments of one motion have the tissue in the same place.
[[nodiscard]] PALPATE_EXPORT bool isSamePlace(const geometry::SurfaceMotion::Moment& a,
                                              const geometry::SurfaceMotion::Moment& b) noexcept;

} // namespace palpate::view
