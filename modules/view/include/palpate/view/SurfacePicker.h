// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Types.h>
#include <palpate/geometry/SurfaceIndex.h>
#include <palpate/geometry/SurfaceMotion.h>
#include <palpate/geometry/TriangleMesh.h>

#include <cstdint>
#include <optional>

namespace palpate::view {

using core::Vec3;

/// Viewing ray.
struct Ray
{
    Vec3 p_W = Vec3::Zero();  ///< origin [mm]
    Vec3 d_W = Vec3::UnitZ(); ///< unit direction
};

/// Intersection of a ray with a surface.
struct RayHit
{
    double distance_mm = 0.0;   ///< along the ray
    Vec3 p_W = Vec3::Zero();    ///< [mm]
    Vec3 n_W = Vec3::UnitZ();   ///< unit normal of the triangle, facing the ray's origin
    std::uint32_t triangle = 0; ///< index of the triangle in the `SurfaceIndex` or in the mesh
    Vec3 rest_W = Vec3::Zero(); ///< the same place on the rest shape of a moving surface, else `p_W` [mm]
    bool isBehind = false;      ///< the ray comes from the inner side of the triangle
};

/// Finds the first triangle that a ray hits, from either side. Uses the hierarchy of the haptic surface, so the
/// pointer hits exactly the surface that the hand touches.
/// @return nothing when the ray misses
/// @par Cost About log n: microseconds on a million triangles.
[[nodiscard]] PALPATE_EXPORT std::optional<RayHit> firstHit(const geometry::SurfaceIndex& surface, const Ray& ray);

/// Same for a moving surface. @param surface  at rest; @param moment  of `motion`
/// The ray is taken to the rest shape in pieces of at most 5 mm, of which there are at most 64.
/// @par Cost tens of microseconds.
[[nodiscard]] PALPATE_EXPORT std::optional<RayHit> firstHit(const geometry::SurfaceIndex& surface,
                                                            const geometry::SurfaceMotion& motion,
                                                            const geometry::SurfaceMotion::Moment& moment,
                                                            const Ray& ray);

/// Same for a mesh without hierarchy, which cannot be touched.
/// @param bounds  bounding box of the mesh. @par Cost O(triangles) when the ray hits `bounds`, a few ns per triangle.
[[nodiscard]] PALPATE_EXPORT std::optional<RayHit> firstHit(const geometry::TriangleMesh& mesh, const core::Box& bounds,
                                                            const Ray& ray);

} // namespace palpate::view
