// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "probe/PointProbe.h"

namespace palpate::haptics::internal {

/// Nearest point of a triangle to a point, and which of its features it lies on.
struct Nearest
{
    Vec3 q;                    ///< [mm]
    Vec3 away;                 ///< from q to the point, to the rounding of the point's own differences [mm]
    Vec3 along = Vec3::Zero(); ///< unit direction of the edge that q lies on; zero on the face and at a corner
    bool isCurved = false;     ///< on an edge or a corner: a ball rolls around it
    int edge = -1;             ///< that q lies on: 0 … 2, from corner a, b, c to the next; else -1
    int corner = -1;           ///< that q is: 0 … 2; else -1
};

/// @par Source Ericson, Real-Time Collision Detection (2005), 5.1.5: closest point on triangle to point.
/// @par Real-time Wait-free.
[[nodiscard]] Nearest nearestOn(const Facet& facet, const Vec3& p) noexcept PALPATE_NONBLOCKING;

/// Where a moving ball meets a facet that blocks it.
struct BallCrossing
{
    double key = 0.0;        ///< share of the move at which the ball touches; 0 when it does already
    double stop = 0.0;       ///< share that may be made: there the gap is the skin
    double closing_mm = 0.0; ///< how much nearer the whole move would lead, to first order, when it touches already
    Facet facet;
    int side = 1;         ///< of the facet's plane that the centre is on
    bool isTimed = false; ///< the share was asked for, which costs as much again, whether or not it blocks
};

/// Tests whether `facet` blocks a ball whose centre makes the straight move x → y: the centre starts in front of the
/// plane (on either side where there is no inside) and comes nearer than `radius_mm` to the triangle. A ball that
/// starts nearer than that may leave, but come no nearer.
///
/// The set of centres that touch is the triangle's own prism, three cylinders and three spheres: the first root of
/// those is the first touch, since the distance from a convex set along a line is convex. The parts overlap where they
/// join, so rounding opens no gap between them or between neighbours.
/// @param limit            crossings beyond this share are of no interest
/// @param leastClosing_mm  a facet that touches already and stands less against the move than this is of no interest
/// @par Real-time Wait-free.
[[nodiscard]] bool blocksBall(const Facet& facet, const Vec3& x, const Vec3& y, double radius_mm, double limit,
                              BallCrossing& crossing, double leastClosing_mm = 0.0) noexcept PALPATE_NONBLOCKING;

} // namespace palpate::haptics::internal
