// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/SurfaceIndex.h"

#include <palpate/core/Export.h>

#include <cstdint>
#include <optional>

namespace palpate::geometry {

/// Point of a surface that is closest to a given point.
struct NearestPoint
{
    double distance_mm = 0.0; ///< to the surface, also for points inside [mm]
    Vec3 at = Vec3::Zero();   ///< point on the surface, in the frame of the surface [mm]
};

/// Finds the closest point of a surface, exactly up to the rounding of doubles.
/// @param p  in the frame of the surface [mm]
/// @param within_mm  an upper bound of the distance, if one is known: only saves time. At a neighbouring point it is
/// the distance found there plus the distance of the two points.
/// @return std::nullopt for a surface without triangles, or if it is farther away than `within_mm`
/// @par Cost Some microseconds without a bound, about 1 us with a close one. Any thread.
[[nodiscard]] PALPATE_EXPORT std::optional<NearestPoint> nearestPoint(const SurfaceIndex& surface, const Vec3& p,
                                                                      std::optional<double> within_mm = {});

/// Position of two structures relative to each other.
enum class Relation : std::uint8_t
{
    Apart,    ///< the surfaces do not meet, and neither structure contains a part of the other
    Crossing, ///< the surfaces cross or touch
    Inside,   ///< the first structure, or a separate part of it, lies in the second, which is closed
    Around    ///< the second structure, or a separate part of it, lies in the first, which is closed
};

/// Least distance of two structures with its place.
struct SurfaceDistance
{
    Relation relation = Relation::Apart;
    double distance_mm = 0.0;    ///< between the structures: 0 unless they are apart
    double surface_mm = 0.0;     ///< between the surfaces: 0 only if they cross or touch; for a lump its cover
    Vec3 onFirst = Vec3::Zero(); ///< closest points of the surfaces; where they cross, both are the same point [mm]
    Vec3 onSecond = Vec3::Zero();
};

/// Finds the least distance between two structures: exactly, triangle against triangle, up to the rounding of doubles
/// (below 1e-9 mm for structures of the human body). Only a closed surface has an inside.
/// @return std::nullopt if either surface has no triangles
/// @par Source Branch and bound: spheres around runs of triangles of the smaller surface, in the order of its
/// hierarchy, against the hierarchy of the larger one. The first bound comes from alternating projections (Cheney and
/// Goldstein, 1959).
/// @par Cost O(n log n) in the smaller surface, resources/docs/distances.md. One thread; any but the servo thread.
[[nodiscard]] PALPATE_EXPORT std::optional<SurfaceDistance> surfaceDistance(const SurfaceIndex& first,
                                                                            const SurfaceIndex& second);

} // namespace palpate::geometry
