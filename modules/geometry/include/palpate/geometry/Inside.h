// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/SurfaceIndex.h"

namespace palpate::geometry {

/// @return how far along a ray it meets a triangle [mm], from either side; infinite when it does not. A ray through an
/// edge meets both neighbours, so that none falls between them.
/// @param d  unit direction
/// @par Source Möller & Trumbore, Fast, Minimum Storage Ray/Triangle Intersection (1997).
[[nodiscard]] double distanceAlongRay(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p, const Vec3& d);

/// Tells whether a point is inside a closed surface: a ray from it leaves an odd number of times, as most of three rays
/// say, so that one that grazes an edge decides nothing. A point beyond the surface's box is outside without a ray.
/// Unspecified for a surface without an inside, and for a point within 1e-9 of the extent of the surface.
/// @param p  in the frame of the surface [mm]
/// @par Cost about log n a ray: microseconds on a million triangles. Any thread but the servo's.
[[nodiscard]] bool isInside(const SurfaceIndex& surface, const Vec3& p);

} // namespace palpate::geometry
