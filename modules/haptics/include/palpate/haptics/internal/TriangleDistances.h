// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/internal/FacetGroup.h"

namespace palpate::haptics::internal {

/// Eight triangles as floats relative to an origin near them: for distances from a point to all of them at once.
struct alignas(32) TriangleGroup
{
    Corners corners;           ///< [mm]
    float normal[3][kLanes];   ///< not of unit length; zero for a triangle too flat for floats [mm²]
    float perNormal2[kLanes];  ///< 1 / squared length of `normal`
    float perEdge2[3][kLanes]; ///< 1 / squared length of ab, ac and bc [1/mm²]
};

/// @return the largest coordinate [mm]
float derive(const Corners& corners, TriangleGroup& group) noexcept PALPATE_NONBLOCKING;

/// Distances from p to the triangles, to a few ulp of the largest coordinate.
/// @param distance_mm  one for each of the groups' lanes; 0 for a triangle too flat to tell
void distances(const TriangleGroup* groups, int count, const float* p, float* distance_mm) noexcept PALPATE_NONBLOCKING;

/// @return bit i set where distance i, of up to 64 by eights, is greater than `beyond` and at most `upTo`
[[nodiscard]] std::uint64_t lanesBetween(const float* distance_mm, int count, float beyond,
                                         float upTo) noexcept PALPATE_NONBLOCKING;

} // namespace palpate::haptics::internal
