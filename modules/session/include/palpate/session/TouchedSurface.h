// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/geometry/TriangleMesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace palpate::session {

/// Contact measures at the vertices of one structure's surface; definitions in docs/measures.md.
///
/// Triangles with edges longer than half the distance are split, so that coarse and fine meshes are measured at the
/// same resolution. The vertices are sample points, each with its share of the area.
class PALPATE_EXPORT TouchedSurface
{
  public:
    /// @param distance_mm  > 0: distance within which the contact touches a surface point [mm]
    TouchedSurface(const geometry::TriangleMesh& mesh, double distance_mm);

    /// Adds a tick in contact. @param p_WG  contact point [mm]
    /// @return the nearest original vertex; empty if there is none within the distance
    /// @par Cost proportional to the number of vertices within about the distance
    std::optional<std::uint32_t> add(const core::Vec3& p_WG, double force_N, double depth_mm, double dt_s);

    /// Split mesh; the original vertices come first.
    [[nodiscard]] const geometry::TriangleMesh& mesh() const noexcept { return m_mesh; }
    /// Time that the contact was within the distance of each vertex [s].
    [[nodiscard]] const std::vector<double>& dwell_s() const noexcept { return m_dwell_s; }
    /// Maximum force during that time [N].
    [[nodiscard]] const std::vector<double>& peakForce_N() const noexcept { return m_peakForce_N; }
    /// Maximum depth of the hand below the surface during that time [mm].
    [[nodiscard]] const std::vector<double>& peakDepth_mm() const noexcept { return m_peakDepth_mm; }
    [[nodiscard]] double area_mm2() const noexcept { return m_area_mm2; }
    /// Area within the distance of any contact [mm²].
    [[nodiscard]] double coveredArea_mm2() const;

  private:
    using Cell = std::array<std::int64_t, 3>;
    struct CellHash
    {
        std::size_t operator()(const Cell& cell) const noexcept;
    };
    void split(const geometry::TriangleMesh& mesh, double longest_mm);
    [[nodiscard]] Cell cellOf(const core::Vec3& p) const;

    double m_distance_mm;
    std::size_t m_given; ///< number of original vertices
    geometry::TriangleMesh m_mesh;
    std::vector<double> m_share_mm2; ///< area share of each vertex
    std::vector<double> m_dwell_s;
    std::vector<double> m_peakForce_N;
    std::vector<double> m_peakDepth_mm;
    double m_area_mm2 = 0.0;
    std::vector<std::uint32_t> m_order;                                                  ///< vertices, grouped by cell
    std::unordered_map<Cell, std::pair<std::uint32_t, std::uint32_t>, CellHash> m_cells; ///< range in m_order
};

} // namespace palpate::session
