// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/SurfaceIndex.h"

#include <cstddef>
#include <optional>

namespace palpate::geometry {

/// Where two surfaces come near each other.
struct SurfaceGap
{
    double distance_mm = 0.0; ///< least distance found; 0 where they touch or cross
    Vec3 at = Vec3::Zero();   ///< middle between the two nearest points, world frame [mm]
    bool isBounded = false;   ///< the bound on pairs was hit: they may be nearer elsewhere
};

/// Finds the least distance between two surfaces, where it is at most `within_mm`.
/// @param touching_mm  ends the search: surfaces as near as that touch, and how near they come elsewhere is of no
///                     interest
/// @param pairs  of triangles that are measured at most; counted, so that the same surfaces give the same answer
/// @return nothing where they stay farther apart
/// @par Cost O(n log n) in the triangles near the other surface; 0.3 us a pair. Any thread.
[[nodiscard]] std::optional<SurfaceGap> nearestWithin(const SurfaceIndex& a, const SurfaceIndex& b, double within_mm,
                                                      double touching_mm, std::size_t pairs = 5'000'000);

} // namespace palpate::geometry
