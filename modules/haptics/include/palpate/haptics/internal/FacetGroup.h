// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Realtime.h>

#include <cstdint>

namespace palpate::haptics::internal {

/// Eight facets as floats relative to an origin near them, side by side, so that eight are told off a move at once.
/// What floats cannot tell is kept: nothing here decides a result.
struct alignas(32) FacetGroup
{
    static constexpr int kLanes = 8;

    float normal[3][kLanes];         ///< unit, of the front; by axis, then facet
    float offset[kLanes];            ///< of the plane from the origin, along the normal [mm]
    float slenderness[kLanes];       ///< longest edge squared over twice the area: multiplies the normal's rounding
    float low[3][kLanes];            ///< box of the triangle, rounded outwards [mm]
    float high[3][kLanes];           ///< [mm]
    std::int32_t isTwoSided[kLanes]; ///< all ones or zero
};

/// Eight triangles: corner a from the origin, and the edges to the other two. [mm]
struct alignas(32) Corners
{
    float a[3][FacetGroup::kLanes];
    float ab[3][FacetGroup::kLanes];
    float ac[3][FacetGroup::kLanes];
};

/// Fills everything of `group` but `isTwoSided`. A triangle too flat for floats is never told off.
/// @return the largest coordinate [mm]
float derive(const Corners& corners, FacetGroup& group) noexcept PALPATE_NONBLOCKING;

/// @param coordinates_mm  sum of the largest coordinates of x, of y and of the groups: what bounds the rounding
/// @param count  facets in the groups, up to 64
/// @return bit i set where facet i may block the move x → y
[[nodiscard]] std::uint64_t crossedLanes(const FacetGroup* groups, int count, const float* x, const float* y,
                                         float coordinates_mm) noexcept PALPATE_NONBLOCKING;

/// The same for a chain of straight moves at once.
/// @param path  its `points` points, as many as there are moves and one, by axis
/// @param coordinates_mm  twice the largest coordinate of the path, and that of the groups
[[nodiscard]] std::uint64_t crossedLanes(const FacetGroup* groups, int count, const float (*path)[3], int points,
                                         float coordinates_mm) noexcept PALPATE_NONBLOCKING;

/// The corners' numbers of eight triangles, and whose they are.
struct alignas(32) CornerGroup
{
    std::uint32_t corner[3][FacetGroup::kLanes];
    std::uint32_t structure[FacetGroup::kLanes];
};

/// @return bit i set where triangle i has both corners
[[nodiscard]] std::uint64_t lanesAtEdge(const CornerGroup* groups, int count, std::uint32_t structure,
                                        std::uint32_t from, std::uint32_t to) noexcept PALPATE_NONBLOCKING;

/// @return bit i set where facet i may come within `reach_mm` of g
[[nodiscard]] std::uint64_t nearLanes(const FacetGroup* groups, int count, const float* g, float reach_mm,
                                      float coordinates_mm) noexcept PALPATE_NONBLOCKING;

} // namespace palpate::haptics::internal
