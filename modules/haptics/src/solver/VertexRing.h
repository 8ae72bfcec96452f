// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "probe/PointProbe.h"

#include <span>

namespace palpate::haptics::internal {

/// Tells whether a god-object at the common corner of `facets` is held there against every direction.
///
/// Around a vertex whose facets close a ring, free space is a cone of directions bounded by the facets' sectors. If any
/// direction in it leads towards the HIP, so does the pull itself, its projection into one of the sectors, or one of
/// the edges between them: where the pull is blocked, none of the projections falls into its own sector and no edge
/// leads nearer, the god-object has arrived.
/// @param facets     all those that are touched
/// @param from       where the pull is tried from, within skins of the corner and in front of the facets [mm]
/// @param wanted     pull: HIP - god-object [mm]
/// @param enough_mm  distances to the HIP greater than this are no gain, > 0
/// @return false when that cannot be told: the facets do not close one ring, or have two sides, or some direction leads
/// on.
/// @par Real-time Wait-free.
[[nodiscard]] bool isHeldByRing(std::span<const Facet> facets, const Vec3& from, const Vec3& wanted,
                                double enough_mm) noexcept PALPATE_NONBLOCKING;

} // namespace palpate::haptics::internal
