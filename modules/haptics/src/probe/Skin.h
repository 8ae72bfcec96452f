// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>
#include <palpate/geometry/SurfaceIndex.h>

#include <algorithm>
#include <limits>

namespace palpate::haptics::internal {

// The ladder of distances around a facet, in skins: a skin is the gap that a god-object keeps to it
// (SurfaceIndex::skin_mm), eight times the worst rounding of a plane's distance. From the lowest rung to the highest.

inline constexpr double kRoundingOfMoves = 1e-3; ///< a shorter move is rounding, and is not made

/// How far behind a plane a move may start and still count as starting on it: it covers the rounding of positions that
/// were computed to lie in front. Half the thickness of the plate around a facet with a front only.
inline constexpr double kOnPlane = 1.0 / 16.0;

/// Half the thickness of the plate around a facet without an inside, and how much wider than the facet it is.
inline constexpr double kPlate = 0.5;

inline constexpr double kLifted = 0.5; ///< height above the next facet from which on it is walked on

inline constexpr double kStanding = 0.6; ///< height from which on a god-object stands as one that has walked there

/// A move that starts as near to a facet's plane touches the facet, if it would meet it within kTouched.
inline constexpr double kTouching = 1.5;

inline constexpr double kSupporting = 2.0; ///< height up to which a facet supports a god-object

inline constexpr double kBesideEdge = 8.0; ///< beyond an edge that still is at it

inline constexpr double kLeastGain = 16.0; ///< a way out of a corner must lead so much nearer to the HIP

/// How near to a facet's edge a god-object touches more than that facet: with a skin's gap to each of two walls that
/// meet at a sharp angle it stands so far from a third at their edge.
inline constexpr double kTouched = 64.0;

inline constexpr double kNearby = 2.0 * kTouched; ///< as far as facets around a place can be asked for

// What SurfaceIndex::isClear shows must cover what a walk does (resources/docs/clear-facets.md, "What a walk rests
// on").
static_assert(geometry::SurfaceIndex::kClearHeight >= kTouching && geometry::SurfaceIndex::kClearHeight >= kSupporting,
              "what touches or supports a walking god-object is within the height that was cleared");
static_assert(kLifted <= kStanding && kStanding <= 1.0, "a walk's moves begin and end where the next one may");
static_assert(kPlate <= kLifted, "a walk over an edge stays out of the plate of the facet before");
static_assert(kLifted / 2.0 <= geometry::SurfaceIndex::kClearApart - 3.0 * geometry::SurfaceIndex::kClearHeight,
              "lifted over an edge, a walk stays as near to it as was cleared: tan(53 deg / 2) is half");
static_assert(kNearby * 512.0 <= geometry::SurfaceIndex::kClearOfCorners,
              "far beyond all that a corner's facets can touch");

/// Violation of a plane that is rounding: a thousandth of the skin, or what a spring of this length leaves. [mm]
[[nodiscard]] inline double allowance(double skin_mm, const core::Vec3& wanted) noexcept
{
    return std::max(kRoundingOfMoves * skin_mm, 8.0 * std::numeric_limits<double>::epsilon() * wanted.norm());
}

} // namespace palpate::haptics::internal
