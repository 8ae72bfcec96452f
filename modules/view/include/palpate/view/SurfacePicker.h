// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>
#include <palpate/geometry/SurfaceIndex.h>
#include <palpate/geometry/TriangleMesh.h>

#include <cstdint>
#include <optional>

namespace palpate::view {

using core::Vec3;

/// A half line from the viewer into the scene.
struct Ray
{
    Vec3 p_W = Vec3::Zero();  ///< start [mm]
    Vec3 d_W = Vec3::UnitZ(); ///< unit direction
};

/// Where a ray first meets a surface.
struct RayHit
{
    double distance_mm = 0.0;   ///< along the ray
    Vec3 p_W = Vec3::Zero();    ///< [mm]
    Vec3 n_W = Vec3::UnitZ();   ///< unit normal of the triangle, turned towards the ray's start
    std::uint32_t triangle = 0; ///< position in the index, or in the mesh
};

/// Finds the first triangle that a ray meets, from either side, over the hierarchy of the haptic copy: what the pointer
/// shows is exactly what the hand will touch. About log n: microseconds on a million triangles.
/// @return nothing when the ray misses
[[nodiscard]] std::optional<RayHit> firstHit(const geometry::SurfaceIndex& surface, const Ray& ray);

/// The same for a surface that nothing can touch, and that has no hierarchy.
/// @param bounds  of the mesh. @par Cost O(triangles) when the ray meets them, a few ns each.
[[nodiscard]] std::optional<RayHit> firstHit(const geometry::TriangleMesh& mesh, const core::Box& bounds,
                                             const Ray& ray);

} // namespace palpate::view
