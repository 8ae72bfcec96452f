// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/SurfaceIndex.h"

#include <palpate/core/Export.h>
#include <palpate/core/Realtime.h>

namespace palpate::geometry {

/// Intersects a ray with a triangle, from either side. A ray through a shared edge hits both triangles, so no ray slips
/// between neighbours.
/// @return distance along the ray [mm]; infinite without an intersection
/// @param d  unit direction
/// @par Real-time Wait-free.
/// @par Source Möller & Trumbore, Fast, Minimum Storage Ray/Triangle Intersection (1997).
[[nodiscard]] PALPATE_EXPORT double distanceAlongRay(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p,
                                                     const Vec3& d) noexcept PALPATE_NONBLOCKING;

/// Point-in-solid test for a closed surface: ray parity, decided by the majority of three rays so that a ray that
/// grazes an edge cannot decide alone. Points outside the bounding box are rejected without a ray. The result is
/// unspecified for open surfaces and for points within 1e-9 of the surface's extent from the surface.
/// @param p  point in the frame of the surface [mm]
/// @par Cost About O(log n) for each ray: microseconds for a million triangles. Any thread except the servo thread.
[[nodiscard]] PALPATE_EXPORT bool isInside(const SurfaceIndex& surface, const Vec3& p);

} // namespace palpate::geometry
