// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/MeshReport.h>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace palpate::buried {

using core::Vec3;

/// Where a finger presses.
struct PressPlace
{
    Vec3 p_W;               ///< on the organ's surface [mm]
    Vec3 n_W;               ///< outward, unit length
    double radius_mm = 5.0; ///< of the contact
};

/// A lump's surface made ready for many presses: its share of a press's energy as one sum over its triangles, without
/// voxels and without asking what is inside. Seen from the middle of the model's pressure, which lies
/// `bellOf(radius)` above the surface, the density can be integrated along each ray: from R outwards, with
/// h = R cos(angle to the axis), to `(6 c / pi) (h^2 - c h + c^2 / 3) / R^3`; above the surface it stands still at
/// `(2 / pi) (h / R)^3`. The share is the sum of what enters less what leaves, by solid angles `x . dA / R^3`.
/// @par Source resources/docs/felt.md
class LumpShape
{
  public:
    static constexpr std::size_t kUsualTriangles = 500;
    /// A share below this is told as 0, where the lump's box alone shows it: far away.
    static constexpr double kLeastShare = 1e-3;

    /// @param surface  closed, normals outwards, world frame [mm]
    /// @param most  triangles that are used: a surface of more is decimated, and keeps its volume. 0: all.
    explicit LumpShape(const geometry::RepairedMesh& surface, std::size_t most = kUsualTriangles);

    /// @param presses_mm  how deep the finger is pressed in, ascending; @param shares  S for each; 0 … 1 but for
    /// rounding
    /// @par Cost some 5 ns a triangle and press; more for the few that are wide for their distance. Any thread; the
    /// same
    ///      bits on each.
    void shares(const PressPlace& place, std::span<const double> presses_mm, std::span<double> shares) const;

    [[nodiscard]] std::size_t triangleCount() const noexcept { return m_triangles.size(); }

    /// @return a distance that the lump is not nearer than [mm]; negative near it.
    [[nodiscard]] double atLeastAway(const Vec3& p_W) const { return (p_W - m_middle).norm() - m_reach_mm; }

  private:
    struct Face
    {
        Vec3 centroid, area; ///< [mm], outward [mm^2]
    };
    /// Seen from more than kAfar times its size a lump of so few triangles has the same share within a hundredth.
    static constexpr std::size_t kFromAfar = 64;
    static constexpr double kAfar = 2.0;

    [[nodiscard]] bool isFar(const PressPlace& place, double deepest_mm) const;
    [[nodiscard]] bool isAround(const Vec3& p_W) const;

    std::vector<Vec3> m_vertices;
    std::vector<Vec3> m_vertexAreas; ///< of all triangles around each
    std::vector<Face> m_faces;
    double m_widest2_mm2 = 0.0; ///< square of the longest edge
    std::shared_ptr<const LumpShape> m_fromAfar;
    std::vector<geometry::Triangle> m_triangles;
    double m_volume_mm3 = 0.0;
    Vec3 m_middle = Vec3::Zero();
    double m_reach_mm = 0.0; ///< of the farthest vertex from the middle
};

} // namespace palpate::buried
