// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RandomScene.h"

#include <optional>

namespace palpate::adversary {

using Long3 = Eigen::Matrix<long double, 3, 1>;

struct JudgedTriangle
{
    std::array<Vec3, 3> corner; ///< counter-clockwise seen from the front [mm]
    Vec3 n = Vec3::Zero();      ///< unit
    core::Box box;
    std::uint32_t structure = 0;
    bool isTwoSided = false;
    int solid = -1; ///< the enclosing body of the layer, if known to have no cavity; -1: none
};

/// A closed set of triangles as generated, including duplicates that the engine may remove.
class Body
{
  public:
    explicit Body(std::vector<std::array<Vec3, 3>> triangles);

    /// Returns how often the surface winds around a point: signed ray crossings in long double, or the sum of the solid
    /// angles where a crossing is ambiguous. Returns nothing for a point on the surface.
    [[nodiscard]] std::optional<int> winding(const Vec3& p) const;
    [[nodiscard]] double distance_mm(const Vec3& p) const;
    [[nodiscard]] const std::vector<std::array<Vec3, 3>>& triangles() const { return m_triangles; }

    bool isOneSided = true; ///< only front contacts

  private:
    [[nodiscard]] std::optional<int> windingByRay(const Vec3& p) const;

    std::vector<std::array<Vec3, 3>> m_triangles;
    std::vector<Eigen::AlignedBox2d> m_seen; ///< per triangle: bounding box projected along the ray
    core::Box m_box;
    double m_magnitude_mm = 0.0;
};

/// Two-sided triangles that are connected over edges.
struct Sheet
{
    std::vector<std::uint32_t> triangles; ///< indices in the layer
    std::vector<std::array<Vec3, 2>> rim; ///< edges that an odd number of triangles share
    core::Box box;
};

/// The structures of one layer as the documentation defines contact, derived without the engine's code: equal vertices
/// of a structure are merged, the same three vertices are one triangle, a part is connected over edges, and a part has
/// an inside if each of its edges is traversed equally often in both directions.
struct JudgedLayer
{
    JudgedLayer(const RandomScene& scene, std::uint32_t layer);

    std::vector<JudgedTriangle> triangles;
    std::vector<Body> bodies;
    std::vector<Sheet> sheets;
    double skin_mm = 0.0; ///< the clearance that the engine reports

  private:
    void add(const RandomMesh& mesh, std::uint32_t structure);
};

[[nodiscard]] double distanceToSegment_mm(const Vec3& p, const Vec3& a, const Vec3& b);
[[nodiscard]] double distanceToTriangle_mm(const Vec3& p, const std::array<Vec3, 3>& t);
/// Returns the smallest distance between a segment and a triangle [mm]; 0 if they intersect.
[[nodiscard]] double distanceOfSegment_mm(const Vec3& from, const Vec3& to, const std::array<Vec3, 3>& t);
/// Returns whether the segment crosses the interior of the triangle with neither end in its plane; nothing if the
/// answer is ambiguous.
[[nodiscard]] std::optional<bool> crosses(const Vec3& from, const Vec3& to, const std::array<Vec3, 3>& t);

} // namespace palpate::adversary
