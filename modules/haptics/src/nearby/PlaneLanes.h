// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Realtime.h>

#include <cstdint>

namespace palpate::haptics::internal {

/// Number of facets tested at once.
inline constexpr int kLanes = 8;

/// Eight triangles in single precision relative to a nearby origin: corner a, and the edges from a to the other two
/// corners [mm].
struct alignas(32) Corners
{
    float a[3][kLanes];
    float ab[3][kLanes];
    float ac[3][kLanes];
    std::int32_t isTwoSided[kLanes]; ///< all ones or zero
};

/// Converts the corners of eight triangles to single precision.
/// @param a,b,c  addresses of the corners; four numbers are read from each [mm]
/// @param origin  origin of the result; four numbers are read [mm]
/// @param corners  result
void setCorners(const double* const* a, const double* const* b, const double* const* c, const double* origin,
                Corners& corners) noexcept PALPATE_NONBLOCKING;

/// Eight facets in single precision relative to a nearby origin, in structure-of-arrays layout, to test eight facets
/// against a move at once. A facet that cannot be decided in single precision is kept, so that results never depend on
/// this filter.
struct alignas(32) FacetGroup
{
    float normal[3][kLanes];    ///< of the front, with twice the area as length; by axis, then facet [mm²]
    float offset[kLanes];       ///< offset of the plane from the origin along the normal [mm³]
    float longest2[kLanes];     ///< squared longest edge: factor of the rounding error of distances [mm²]
    float perShortest2[kLanes]; ///< 1 / squared shortest edge: factor of the tolerance of the edge tests, see kPassing
                                ///< in PlaneLanes.cpp [1/mm²]
    float low[3][kLanes];       ///< bounding box of the triangle, rounded outwards [mm]
    float high[3][kLanes];      ///< [mm]
    std::int32_t isTwoSided[kLanes]; ///< all ones or zero
};

/// Computes the derived members of a group. A triangle too small for single precision is never ruled out.
/// @return the largest coordinate [mm]
float derive(const Corners& corners, FacetGroup& group) noexcept PALPATE_NONBLOCKING;

/// Finds the facets that may block the move x → y.
/// @param coordinates_mm  sum of the largest coordinates of x, of y and of the groups: bounds the rounding error
/// @param around_mm  distance from a facet at which it may block: a skin
/// @param count  number of facets in the groups, up to 64
/// @return bit i is set if facet i may block the move
[[nodiscard]] std::uint64_t crossedLanes(const FacetGroup* groups, int count, const float* x, const float* y,
                                         float coordinates_mm, float around_mm) noexcept PALPATE_NONBLOCKING;

/// Same for a chain of straight moves.
/// @param path  the points of the path, by axis
/// @param points  number of points, one more than the number of moves
/// @param coordinates_mm  twice the largest coordinate of the path, plus the largest coordinate of the groups
[[nodiscard]] std::uint64_t crossedLanes(const FacetGroup* groups, int count, const float (*path)[3], int points,
                                         float coordinates_mm, float around_mm) noexcept PALPATE_NONBLOCKING;

/// Finds the facets near a point.
/// @return bit i is set if facet i may be within `reach_mm` of g
[[nodiscard]] std::uint64_t nearLanes(const FacetGroup* groups, int count, const float* g, float reach_mm,
                                      float coordinates_mm) noexcept PALPATE_NONBLOCKING;

/// Returns the minimum distance of g from the facets' boxes, in the maximum norm [mm]: infinite without facets,
/// negative inside a box.
[[nodiscard]] float boxDistance(const FacetGroup* groups, int count, const float* g) noexcept PALPATE_NONBLOCKING;

} // namespace palpate::haptics::internal
