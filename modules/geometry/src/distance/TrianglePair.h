// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/SurfaceIndex.h"

#include <array>
#include <cstdint>

namespace palpate::geometry {

using Corners = std::array<Vec3, 3>;

/// A pair of points, one on each surface.
struct NearPair
{
    Vec3 p, q;
    double distance2 = 0.0; ///< squared distance [mm^2]
};

/// Returns the corners of a triangle. @param i  position in the index's own order
[[nodiscard]] Corners cornersAt(const SurfaceIndex& surface, std::uint32_t i);

/// Returns the pair of a point and the closest point of a triangle.
[[nodiscard]] NearPair nearestOf(const Vec3& p, const Corners& triangle);

/// Returns the closest points of two triangles: between two edges, between a corner and a face, or at an intersection.
/// Triangles without area are treated as their edges.
/// @par Source Segments: Ericson, Real-Time Collision Detection (2005), 5.1.9, with the determinants from the common
/// normal, so that nearly parallel edges keep their accuracy.
[[nodiscard]] NearPair nearestOf(const Corners& a, const Corners& b);

} // namespace palpate::geometry
