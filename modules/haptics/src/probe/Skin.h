// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>
#include <palpate/geometry/SurfaceIndex.h>

#include <algorithm>
#include <limits>

namespace palpate::haptics::internal {

// Tolerances of the solver in skins, in ascending order. A skin (SurfaceIndex::skin_mm) is the gap that a god-object
// keeps to a facet, eight times the worst rounding error of a distance to a plane.

inline constexpr double kMinMove = 1e-3; ///< a shorter move is rounding and is not made

/// Maximum depth behind a plane at which a move still counts as starting on the plane. Covers the rounding of positions
/// that were computed to be in front. Half the thickness of the plate around a one-sided facet.
inline constexpr double kPlaneTolerance = 1.0 / 16.0;

/// Half the thickness of the plate around a two-sided facet, and the distance by which the plate extends beyond the
/// facet's edges.
inline constexpr double kPlate = 0.5;

/// Minimum height above the next facet at which a walk continues on that facet.
inline constexpr double kLiftHeight = 0.5;

/// Minimum height of a god-object that counts as having walked to its facet.
inline constexpr double kMinWalkHeight = 0.6;

/// A move that starts at this height or lower touches the facet, provided that it would meet the facet within
/// kTouchRadius.
inline constexpr double kTouching = 1.5;

inline constexpr double kSupporting = 2.0; ///< maximum height at which a facet supports a god-object

/// A ball that penetrates deeper was placed there rather than pressed in: it may leave, but is not pushed out.
inline constexpr double kMaxPressedDepth = 4.0;

inline constexpr double kEdgeTolerance = 8.0; ///< maximum distance outside an edge that still counts as at the edge

inline constexpr double kLeastGain = 16.0; ///< minimum gain towards the HIP of an escape from a corner

/// Distance from a facet's edge within which a god-object may touch further facets: with a gap of one skin to each of
/// two walls that meet at a sharp angle, the god-object is this far from a third facet at their edge.
inline constexpr double kTouchRadius = 64.0;

inline constexpr double kMaxQueryRadius = 2.0 * kTouchRadius; ///< maximum radius of a query for nearby facets

// SurfaceIndex::isClear must cover everything that a walk does (resources/docs/clear-facets.md, "Assumptions of a
// walk").
static_assert(geometry::SurfaceIndex::kClearHeight >= kTouching && geometry::SurfaceIndex::kClearHeight >= kSupporting,
              "what touches or supports a walking god-object is within the height that was cleared");
static_assert(kLiftHeight <= kMinWalkHeight && kMinWalkHeight <= 1.0,
              "a walk's moves begin and end where the next one may");
static_assert(kPlate <= kLiftHeight, "a walk over an edge stays out of the plate of the facet before");
static_assert(kLiftHeight / 2.0 <=
                  geometry::SurfaceIndex::kClearSeparation - 3.0 * geometry::SurfaceIndex::kClearHeight,
              "lifted over an edge, a walk stays as near to it as was cleared: tan(53 deg / 2) is half");
static_assert(kMaxQueryRadius * 512.0 <= geometry::SurfaceIndex::kClearOfCorners,
              "far beyond all that a corner's facets can touch");

/// Returns the violation of a plane that counts as rounding [mm]: a thousandth of the skin, or the rounding of a spring
/// of this length.
[[nodiscard]] inline double allowance(double skin_mm, const core::Vec3& wanted) noexcept
{
    return std::max(kMinMove * skin_mm, 8.0 * std::numeric_limits<double>::epsilon() * wanted.norm());
}

} // namespace palpate::haptics::internal
