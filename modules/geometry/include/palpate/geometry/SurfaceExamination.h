// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/SurfaceIndex.h"

#include <palpate/core/Export.h>

#include <cstddef>
#include <optional>

namespace palpate::geometry {

/// Work limits of `examine`, as counts rather than times, so that results are reproducible on every machine.
struct ExaminationLimits
{
    std::size_t pairs = 20'000'000; ///< maximum number of triangle pairs tested for crossing, about 2 s
    std::size_t samples = 4096;     ///< maximum number of wall thickness rays
};

/// Quality measures of a surface that depend on the position of its triangles in space; complements `MeshReport`.
struct SurfaceExamination
{
    /// Number of intersecting triangle pairs without a common vertex. Pairs that only touch or are coplanar do not
    /// count.
    std::size_t crossingPairs = 0;
    /// Triangles tested against all others; fewer than the total if the limit was reached.
    std::size_t examinedTriangles = 0;
    bool isPairLimitReached = false; ///< the pair limit was reached: more crossings are possible

    /// Smallest wall thickness, measured through the inside to the opposite surface [mm], over `wallSamples` evenly
    /// spread triangles: an upper bound of the true minimum. Empty for an open surface.
    std::optional<double> thinnestWall_mm;
    Vec3 thinnestAt = Vec3::Zero(); ///< position of the thinnest wall, world frame [mm]
    std::size_t wallSamples = 0;    ///< rays that hit an opposite wall
};

/// Detects self-intersections and measures the wall thickness with the existing haptic index.
///
/// Two triangles cross if an edge of one passes through the other (edges included) from one side to the other, decided
/// by the signs of five tetrahedron volumes. The wall thickness is measured from the centroid of a triangle along the
/// inward normal to the first triangle without a shared vertex that faces within 60° of the opposite direction, so that
/// the edge of a wedge does not count as a wall.
/// @par Cost O(n) box queries, O(samples) segment queries, within `bounds`. Any thread.
[[nodiscard]] PALPATE_EXPORT SurfaceExamination examine(const SurfaceIndex& surface,
                                                        const ExaminationLimits& bounds = {});

} // namespace palpate::geometry
