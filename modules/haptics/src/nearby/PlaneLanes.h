// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Realtime.h>

#include <cstdint>

namespace palpate::haptics::internal {

/// How many facets are ruled out at once.
inline constexpr int kLanes = 8;

/// Eight triangles as floats relative to an origin near them: corner a from the origin, and the edges to the other two.
/// [mm]
struct alignas(32) Corners
{
    float a[3][kLanes];
    float ab[3][kLanes];
    float ac[3][kLanes];
    std::int32_t isTwoSided[kLanes]; ///< all ones or zero
};

/// @param a,b,c  the corners of eight triangles; four numbers are read from each [mm]
/// @param origin  four numbers, too [mm]
void setCorners(const double* const* a, const double* const* b, const double* const* c, const double* origin,
                Corners& corners) noexcept PALPATE_NONBLOCKING;

/// Eight facets as floats relative to an origin near them, side by side, so that eight are tested against a move at
/// once. A facet that floats cannot decide on is kept: nothing here decides a result.
struct alignas(32) FacetGroup
{
    float normal[3][kLanes];         ///< of the front, twice the area long; by axis, then facet [mm²]
    float offset[kLanes];            ///< of the plane from the origin along it [mm³]
    float longest2[kLanes];          ///< longest edge squared: multiplies the rounding of distances [mm²]
    float perShortest2[kLanes];      ///< 1 / shortest edge squared: what that rounds [1/mm²]
    float low[3][kLanes];            ///< box of the triangle, rounded outwards [mm]
    float high[3][kLanes];           ///< [mm]
    std::int32_t isTwoSided[kLanes]; ///< all ones or zero
};

/// A triangle too small for floats is never ruled out.
/// @return the largest coordinate [mm]
float derive(const Corners& corners, FacetGroup& group) noexcept PALPATE_NONBLOCKING;

/// @param coordinates_mm  sum of the largest coordinates of x, of y and of the groups: what bounds the rounding
/// @param around_mm  how far around a facet it may block: a skin
/// @param count  facets in the groups, up to 64
/// @return bit i set where facet i may block the move x → y
[[nodiscard]] std::uint64_t crossedLanes(const FacetGroup* groups, int count, const float* x, const float* y,
                                         float coordinates_mm, float around_mm) noexcept PALPATE_NONBLOCKING;

/// The same for a chain of straight moves at once.
/// @param path  its `points` points, as many as there are moves and one, by axis
/// @param coordinates_mm  twice the largest coordinate of the path, and that of the groups
[[nodiscard]] std::uint64_t crossedLanes(const FacetGroup* groups, int count, const float (*path)[3], int points,
                                         float coordinates_mm, float around_mm) noexcept PALPATE_NONBLOCKING;

/// @return bit i set where facet i may come within `reach_mm` of g
[[nodiscard]] std::uint64_t nearLanes(const FacetGroup* groups, int count, const float* g, float reach_mm,
                                      float coordinates_mm) noexcept PALPATE_NONBLOCKING;

/// @return how far g is from the boxes of all facets, along the axis where it is farthest from each: infinite without
/// any, negative in one [mm]
[[nodiscard]] float boxDistance(const FacetGroup* groups, int count, const float* g) noexcept PALPATE_NONBLOCKING;

} // namespace palpate::haptics::internal
