// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/TriangleMesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace palpate::session {

/// One structure's surface and what was done on it, a number a vertex; definitions in resources/docs/measures.md.
///
/// Triangles longer than half the distance are split, so that a coarse mesh is measured as finely as a fine one: the
/// vertices are sample points of the surface, each standing for its share of the area.
class TouchedSurface
{
  public:
    /// @param distance_mm  > 0: how near the contact must come to touch a point of the surface
    TouchedSurface(const geometry::TriangleMesh& mesh, double distance_mm);

    /// Takes a tick in contact. @param p_WG  contact point [mm]
    /// @return the nearest of the vertices that were given; nothing where none is within the distance
    /// @par Cost of the vertices within about the distance
    std::optional<std::uint32_t> add(const core::Vec3& p_WG, double force_N, double depth_mm, double dt_s);

    /// The vertices that were given come first.
    [[nodiscard]] const geometry::TriangleMesh& mesh() const noexcept { return m_mesh; }
    /// Time that the contact was within the distance of each vertex. [s]
    [[nodiscard]] const std::vector<double>& dwell_s() const noexcept { return m_dwell_s; }
    /// Greatest force meanwhile. [N]
    [[nodiscard]] const std::vector<double>& peakForce_N() const noexcept { return m_peakForce_N; }
    /// Greatest depth of the hand below the surface meanwhile. [mm]
    [[nodiscard]] const std::vector<double>& peakDepth_mm() const noexcept { return m_peakDepth_mm; }
    [[nodiscard]] double area_mm2() const noexcept { return m_area_mm2; }
    /// Area of which the contact came within the distance. [mm²]
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
    std::size_t m_given; ///< vertices that were given
    geometry::TriangleMesh m_mesh;
    std::vector<double> m_share_mm2; ///< area that a vertex stands for
    std::vector<double> m_dwell_s;
    std::vector<double> m_peakForce_N;
    std::vector<double> m_peakDepth_mm;
    double m_area_mm2 = 0.0;
    std::vector<std::uint32_t> m_order; ///< vertices, those of a cell together
    std::unordered_map<Cell, std::pair<std::uint32_t, std::uint32_t>, CellHash> m_cells; ///< range in m_order
};

} // namespace palpate::session
