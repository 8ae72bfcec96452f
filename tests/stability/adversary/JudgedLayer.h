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
    int solid = -1; ///< body of the layer that this is part of, if that is known to have no cavity; -1: none
};

/// A closed set of triangles, as it was made: those that the engine may leave out, as duplicates, included.
class Body
{
  public:
    explicit Body(std::vector<std::array<Vec3, 3>> triangles);

    /// How often the surface winds around a point: signed crossings of a ray, in long double; where one of them is not
    /// plain, the sum of the solid angles. None on the surface itself.
    [[nodiscard]] std::optional<int> winding(const Vec3& p) const;
    [[nodiscard]] double distance_mm(const Vec3& p) const;

    bool isOneSided = true; ///< touched from its front only

  private:
    [[nodiscard]] std::optional<int> windingByRay(const Vec3& p) const;

    std::vector<std::array<Vec3, 3>> m_triangles;
    std::vector<Eigen::AlignedBox2d> m_seen; ///< by triangle: its box, seen along the ray
    core::Box m_box;
    double m_magnitude_mm = 0.0;
};

/// Triangles that are connected over edges and touched from both sides.
struct Sheet
{
    std::vector<std::uint32_t> triangles; ///< of the layer
    std::vector<std::array<Vec3, 2>> rim; ///< edges with an odd number of triangles
    core::Box box;
};

/// The structures of one layer as the documentation says that they are touched, found out without the engine's code:
/// equal vertices of a structure are one, the same three vertices are one triangle, a part is connected over edges and
/// has an inside when each of its edges is passed equally often in both directions.
struct JudgedLayer
{
    JudgedLayer(const RandomScene& scene, std::uint32_t layer);

    std::vector<JudgedTriangle> triangles;
    std::vector<Body> bodies;
    std::vector<Sheet> sheets;
    double skin_mm = 0.0; ///< what the engine says that it keeps off

  private:
    void add(const RandomMesh& mesh, std::uint32_t structure);
};

[[nodiscard]] double distanceToSegment_mm(const Vec3& p, const Vec3& a, const Vec3& b);
[[nodiscard]] double distanceToTriangle_mm(const Vec3& p, const std::array<Vec3, 3>& t);
/// Least distance between a segment and a triangle, 0 where they meet. [mm]
[[nodiscard]] double distanceOfSegment_mm(const Vec3& from, const Vec3& to, const std::array<Vec3, 3>& t);
/// Does the segment pass through the triangle, its plane included at neither end? None when that is not plain.
[[nodiscard]] std::optional<bool> crosses(const Vec3& from, const Vec3& to, const std::array<Vec3, 3>& t);

} // namespace palpate::adversary
