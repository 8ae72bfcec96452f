// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "probe/PointProbe.h"

#include <span>

namespace palpate::haptics::internal {

/// Tests whether a god-object at the common corner of `facets` is held against every direction.
///
/// If the facets around a vertex form a closed ring, free space is a cone of directions bounded by the sectors of the
/// facets. If any direction in the cone leads towards the HIP, so does the pull itself, its projection into one of the
/// sectors, or one of the edges between the sectors. Hence the god-object is at rest if the pull is blocked, no
/// projection is inside its sector and no edge leads nearer.
/// @param facets     all touched facets
/// @param from       start of the pull, within skins of the corner and in front of the facets [mm]
/// @param wanted     pull: HIP - god-object [mm]
/// @param enough_mm  tolerance on the distance to the HIP, > 0
/// @return false if undecided (the facets do not form one closed ring, or are two-sided) or if some direction leads
/// nearer
/// @par Real-time Wait-free.
[[nodiscard]] bool isHeldByVertexRing(std::span<const Facet> facets, const Vec3& from, const Vec3& wanted,
                                      double enough_mm) noexcept PALPATE_NONBLOCKING;

} // namespace palpate::haptics::internal
