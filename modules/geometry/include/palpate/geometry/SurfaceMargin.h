// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/SurfaceIndex.h"

#include <palpate/core/Export.h>
#include <palpate/core/Parallel.h>

#include <span>
#include <vector>

namespace palpate::geometry {

/// How much of a lump's surface is how close to a structure.
struct SurfaceMargin
{
    /// Share of the lump's area in each band of distance to the structure's surface (0 to 1, sum 1): below the first
    /// limit, from each limit to the next, and from the last limit on.
    std::vector<double> shares;
    double insideShare = 0.0; ///< share of the lump's area inside the structure; 0 for an open structure
};

/// Measures the margin of a lump to a structure.
///
/// A triangle lies in one band as a whole if the distance at a point measured near it, plus and minus the way from
/// there to its farthest corner, does; otherwise it is split into four, until its edges are at most
/// `marginResolution_mm` long. Then its centre decides.
/// @param limits_mm  borders of the bands, ascending, e.g. 5 and 10 [mm]
/// @param threads  maximum number of threads; the result does not depend on it
/// @return shares of 0 if either surface has no triangles or the lump has no area
/// @par Cost Mostly along the borders of bands, resources/docs/distances.md. Any thread but the servo thread.
[[nodiscard]] PALPATE_EXPORT SurfaceMargin surfaceMargin(const SurfaceIndex& lump, const SurfaceIndex& structure,
                                                         std::span<const double> limits_mm,
                                                         unsigned threads = core::coreCount());

/// Length of the edges at which `surfaceMargin` stops to split triangles: 0.1 mm, or 1/300 of the lump's diagonal if
/// that is longer. [mm]
[[nodiscard]] PALPATE_EXPORT double marginResolution_mm(const SurfaceIndex& lump);

} // namespace palpate::geometry
