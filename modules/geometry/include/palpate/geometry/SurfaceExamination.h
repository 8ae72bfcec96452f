// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/SurfaceIndex.h"

#include <cstddef>
#include <optional>

namespace palpate::geometry {

/// How much `examine` may do; counted, so that the same surface gives the same answer everywhere.
struct ExaminationBounds
{
    std::size_t pairs = 20'000'000; ///< pairs of triangles that are tested for crossing, about 2 s
    std::size_t samples = 4096;     ///< rays that measure the wall
};

/// What a surface says about itself beyond the counts of `MeshReport`, where its triangles lie in space.
struct SurfaceExamination
{
    /// Pairs of triangles without a common vertex that cross each other. Pairs that only touch, or that lie in one
    /// plane, do not count.
    std::size_t crossingPairs = 0;
    std::size_t examinedTriangles = 0; ///< that were held against all others: fewer than there are when a bound was hit
    bool isCrossingBounded = false;    ///< the bound on pairs was hit: there may be more crossings

    /// Smallest distance from the surface through its inside to the surface opposite [mm], over `wallSamples` triangles
    /// spread evenly: an upper limit of the true one. Nothing for a surface without an inside.
    std::optional<double> thinnestWall_mm;
    Vec3 thinnestAt = Vec3::Zero(); ///< where that was measured, world frame [mm]
    std::size_t wallSamples = 0;    ///< rays that met an opposite wall
};

/// Looks for crossings and measures the wall through the index that touching uses anyway.
///
/// Two triangles cross when an edge of one passes through the other, whose own edges count in, from one side of it to
/// the other (signs of five volumes). A wall is
/// measured from the centroid of a triangle along its inward normal to the first triangle that shares no vertex with it
/// and faces within 60° of the opposite way, so that the edge of a wedge is no wall.
/// @par Cost O(n) box queries, O(samples) segment queries, within `bounds`. Any thread.
[[nodiscard]] SurfaceExamination examine(const SurfaceIndex& surface, const ExaminationBounds& bounds = {});

} // namespace palpate::geometry
