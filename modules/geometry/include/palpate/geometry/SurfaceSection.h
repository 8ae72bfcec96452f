// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/TriangleMesh.h"

#include <palpate/core/Export.h>

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace palpate::geometry {

/// Plane with coordinates: a point (s, t) of the plane is p_W + s u_W + t v_W in the world.
struct PALPATE_EXPORT SectionPlane
{
    Vec3 p_W = Vec3::Zero();  ///< origin of the plane's coordinates [mm]
    Vec3 n_W = Vec3::UnitZ(); ///< unit normal, u x v
    Vec3 u_W = Vec3::UnitX(); ///< unit vector of the first coordinate
    Vec3 v_W = Vec3::UnitY(); ///< unit vector of the second coordinate

    /// Plane through a point. @param n_W  normal, any length above 0
    [[nodiscard]] static SectionPlane through(const Vec3& p_W, const Vec3& n_W);
    /// @return signed distance from the plane, positive on the side of the normal [mm]
    [[nodiscard]] double distance_mm(const Vec3& q_W) const { return n_W.dot(q_W - p_W); }
    [[nodiscard]] Eigen::Vector2d inPlane(const Vec3& q_W) const { return {u_W.dot(q_W - p_W), v_W.dot(q_W - p_W)}; }
    [[nodiscard]] Vec3 inWorld(const Eigen::Vector2d& q) const { return p_W + q.x() * u_W + q.y() * v_W; }
    /// @return true if a box has points on both sides
    [[nodiscard]] bool crosses(const Box& box_W) const;

    friend bool operator==(const SectionPlane&, const SectionPlane&) = default;
};

/// Line in which a plane cuts a surface.
struct SectionContour
{
    std::vector<Eigen::Vector2d> points; ///< in the plane [mm]; a closed contour does not repeat the first point
    /// The line returns to its start and lies on a closed component of the surface, so that it bounds an area. Seen
    /// against the normal of the plane, the inside of an outward surface is on the left.
    bool isClosed = false;
};

/// Cuts a surface with a plane. Vertices in the plane count as above it, so that triangles in the plane, or with an
/// edge or a corner in it, give no contour of their own and a closed surface gives closed contours only.
/// @param vertices  [mm]; may have moved since the surface was repaired
/// @param triangles  of a RepairedMesh, which orients each component consistently
/// @param twoSided  RepairedMesh::twoSided, one per triangle
/// @par Cost One pass over vertices and triangles: 2 to 9 ms for 1.2 million triangles, with `filled`. Any thread.
[[nodiscard]] PALPATE_EXPORT std::vector<SectionContour> sectionOf(std::span<const Vec3> vertices,
                                                                   std::span<const Triangle> triangles,
                                                                   std::span<const std::uint8_t> twoSided,
                                                                   const SectionPlane& plane);

/// Part of a filled section between two horizontal lines of the plane. [mm]
struct SectionStrip
{
    double low = 0.0, high = 0.0;                                          ///< second coordinate
    double leftLow = 0.0, rightLow = 0.0, leftHigh = 0.0, rightHigh = 0.0; ///< first coordinate

    [[nodiscard]] double area_mm2() const { return 0.5 * (high - low) * (rightLow - leftLow + rightHigh - leftHigh); }
    [[nodiscard]] PALPATE_EXPORT bool contains(const Eigen::Vector2d& q) const;
};

/// Fills the area that the closed contours enclose: points with a winding number other than 0. A cavity whose normals
/// point inwards stays empty, and a surface that is inside out is filled all the same. Open contours enclose nothing.
/// @return strips that do not overlap. Where contours of one surface cross each other, a strip at the crossing is
///         inexact by at most the height between two neighbouring points of the contours
/// @par Cost O(points x contours crossing a horizontal line)
[[nodiscard]] PALPATE_EXPORT std::vector<SectionStrip> filled(const std::vector<SectionContour>& contours);

/// @return area of a filled section [mm²]
[[nodiscard]] PALPATE_EXPORT double areaOf(const std::vector<SectionStrip>& strips);

} // namespace palpate::geometry
