// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/geometry/Repair.h>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace palpate::buried {

using core::Vec3;

/// Contact of a pressing finger.
struct ContactPlace
{
    Vec3 p_W;               ///< contact point on the organ's surface [mm]
    Vec3 n_W;               ///< outward normal, unit length
    double radius_mm = 5.0; ///< contact radius
};

/// Lump surface prepared for many evaluations: computes the lump's share of a press's elastic energy as a sum over its
/// triangles, without voxels or point-in-solid tests. In coordinates centred on the model's pressure distribution,
/// `pressureScale(radius)` above the surface, the energy density integrates along each ray from R outwards, with h = R
/// cos(angle to the axis), to `(6 c / pi) (h^2 - c h + c^2 / 3) / R^3`; above the surface the integral is constant at
/// `(2 / pi) (h / R)^3`. The share is the inflow minus the outflow through the triangles, weighted by their solid
/// angles `x . dA / R^3`.
/// @par Source docs/felt.md
class PALPATE_EXPORT LumpShape
{
  public:
    static constexpr std::size_t kDefaultTriangles = 500;
    /// Shares below this value are returned as 0 if the bounding sphere of the lump proves them (distant lumps).
    static constexpr double kLeastShare = 1e-3;

    /// @param surface  closed, outward normals, world frame [mm]
    /// @param most  maximum number of triangles: larger surfaces are decimated with constant volume. 0: no limit.
    explicit LumpShape(const geometry::RepairedMesh& surface, std::size_t most = kDefaultTriangles);

    /// @param presses_mm  indentation depths, ascending
    /// @param shares  output: S for each depth, 0 to 1 apart from rounding
    /// @par Cost About 5 ns for each triangle and press; more for the few triangles that are wide relative to their
    /// distance. Any thread, with bit-identical results.
    void shares(const ContactPlace& place, std::span<const double> presses_mm, std::span<double> shares) const;

    [[nodiscard]] std::size_t triangleCount() const noexcept { return m_triangles.size(); }

    /// @return lower bound of the distance to the lump [mm]; negative near the lump.
    [[nodiscard]] double distanceLowerBound(const Vec3& p_W) const { return (p_W - m_middle).norm() - m_reach_mm; }

  private:
    struct Face
    {
        Vec3 centroid, area; ///< [mm], outward area vector [mm^2]
    };
    /// Coarse version: beyond kCoarseDistance times the lump's size, this many triangles give the share with an error
    /// below 1 %.
    static constexpr std::size_t kCoarseTriangles = 64;
    static constexpr double kCoarseDistance = 2.0;

    [[nodiscard]] bool isFar(const ContactPlace& place, double deepest_mm) const;
    [[nodiscard]] bool isAround(const Vec3& p_W) const;

    std::vector<Vec3> m_vertices;
    std::vector<Vec3> m_vertexAreas; ///< area vectors of all adjacent triangles, summed for each vertex
    std::vector<Face> m_faces;
    double m_widest2_mm2 = 0.0; ///< squared length of the longest edge
    std::shared_ptr<const LumpShape> m_fromAfar;
    std::vector<geometry::Triangle> m_triangles;
    double m_volume_mm3 = 0.0;
    Vec3 m_middle = Vec3::Zero();
    double m_reach_mm = 0.0; ///< distance of the farthest vertex from the middle
};

} // namespace palpate::buried
