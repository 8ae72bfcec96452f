// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "JoinedSurface.h"

#include <cstdint>
#include <vector>

namespace palpate::geometry {

/// Finds triangles with the property SurfaceIndex::isClear. Conservative: some clear triangles may be missed.
///
/// Two conditions are verified for each triangle. First, its corners are smooth: the triangles around a corner form a
/// single fan, each turned by at most 53 degrees from their mean normal and from the next, with angles of at least
/// asin(1/32) at the corner. In projection along the mean normal they are then disjoint, so a point of one of them at
/// distance d from the corner is at least d/89 away from triangles that share only the corner. Second, all triangles
/// without a shared corner are at least kApart skins away, proven by a separating axis. Proof that both conditions
/// suffice: resources/docs/clear-facets.md.
/// @return 1 for each clear triangle, in the index's own order.
/// @par Cost Typically O(n log n), on at most `threads` threads; the result does not depend on their number.
[[nodiscard]] std::vector<std::uint8_t> findClear(const JoinedSurface& surface, unsigned threads);

} // namespace palpate::geometry
