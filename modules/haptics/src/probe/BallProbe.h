// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "probe/PointProbe.h"

namespace palpate::haptics::internal {

/// Closest point on a triangle, and the feature (face, edge or corner) on which that point lies.
struct Nearest
{
    Vec3 q;    ///< closest point [mm]
    Vec3 away; ///< vector from q to the query point, accurate to the rounding of the coordinate differences [mm]
    Vec3 along = Vec3::Zero(); ///< unit direction of the edge that contains q; zero on the face and at a corner
    bool isCurved = false;     ///< q is on an edge or a corner, around which a ball rolls
    int edge = -1;             ///< edge that contains q: 0 to 2, from corner a, b, c to the next; otherwise -1
    int corner = -1;           ///< corner at q: 0 to 2; otherwise -1
};

/// Finds the closest point on a facet.
/// @par Source Ericson, Real-Time Collision Detection (2005), 5.1.5: closest point on triangle to point.
/// @par Real-time Wait-free.
[[nodiscard]] Nearest nearestOn(const Facet& facet, const Vec3& p) noexcept PALPATE_NONBLOCKING;

/// Where a moving ball meets a facet that blocks the move.
struct BallCrossing
{
    double key = 0.0;        ///< fraction of the move at which the ball touches; 0 if already touching
    double stop = 0.0;       ///< fraction of the move that may be made, up to a gap of one skin
    double closing_mm = 0.0; ///< if already touching: first-order decrease of the distance over the whole move
    Facet facet;
    int side = 1;         ///< side of the facet's plane that the centre is on
    bool isTimed = false; ///< the fraction was computed, which doubles the cost, whether or not the facet blocks
};

/// Tests whether `facet` blocks a ball whose centre makes the straight move x → y: the centre starts in front of the
/// plane (or on either side of a two-sided facet) and comes nearer than `radius_mm` to the triangle. A ball that starts
/// nearer may move away, but not closer.
///
/// The set of centres in contact is the union of the triangle's prism, three cylinders and three spheres. The first
/// root of these is the first contact, because the distance from a convex set is convex along a line. The parts overlap
/// at their joints, so rounding opens no gap between them or between adjacent facets.
/// @param limit            crossings beyond this fraction are ignored
/// @param leastClosing_mm  facets that already touch but oppose the move by less than this are ignored
/// @par Real-time Wait-free.
[[nodiscard]] bool blocksBall(const Facet& facet, const Vec3& x, const Vec3& y, double radius_mm, double limit,
                              BallCrossing& crossing, double leastClosing_mm = 0.0) noexcept PALPATE_NONBLOCKING;

} // namespace palpate::haptics::internal
