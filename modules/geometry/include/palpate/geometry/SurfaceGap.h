// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/SurfaceIndex.h"

#include <palpate/core/Export.h>

#include <cstddef>
#include <optional>

namespace palpate::geometry {

/// Closest approach of two surfaces.
struct SurfaceGap
{
    double distance_mm = 0.0; ///< smallest distance found; 0 if they touch or cross
    Vec3 at = Vec3::Zero();   ///< midpoint of the two closest points, world frame [mm]
    bool isBounded = false;   ///< the pair limit was reached: a smaller distance is possible
};

/// Finds the smallest distance between two surfaces if it is at most `within_mm`.
/// @param touching_mm  distance at which the surfaces count as touching; ends the search
/// @param pairs  maximum number of triangle pairs to measure; a count, so that results are reproducible
/// @return std::nullopt if the surfaces are farther apart
/// @par Cost O(n log n) in the triangles near the other surface; 0.3 us for each pair. Any thread.
[[nodiscard]] PALPATE_EXPORT std::optional<SurfaceGap> nearestWithin(const SurfaceIndex& a, const SurfaceIndex& b,
                                                                     double within_mm, double touching_mm,
                                                                     std::size_t pairs = 5'000'000);

} // namespace palpate::geometry
