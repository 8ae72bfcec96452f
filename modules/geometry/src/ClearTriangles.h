// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "JoinedSurface.h"

#include <cstdint>
#include <vector>

namespace palpate::geometry {

/// Finds the triangles that SurfaceIndex::isClear promises something about; others may be left out for simplicity's
/// sake.
///
/// Two things are shown of each. Its corners are smooth: the triangles around one form a single fan, each turned by at
/// most 53 degrees from their mean normal and from the next, none with an angle below asin(1/32) there: seen along the
/// mean normal they lie side by side, so whatever is d away from the corner on one of them is d/89 or more from those
/// that only share the corner. And all triangles that share no corner with it are kApart skins away: an axis separates
/// them. resources/docs/clear-facets.md says why that is enough.
/// @return 1 for each triangle that is clear, in the index's own order.
/// @par Cost O(n log n) as a rule, on at most `threads` threads; the result does not depend on their number.
[[nodiscard]] std::vector<std::uint8_t> findClear(const JoinedSurface& surface, unsigned threads);

} // namespace palpate::geometry
