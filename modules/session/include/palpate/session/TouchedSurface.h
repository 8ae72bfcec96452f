// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/TouchPlace.h"

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

    /// A tick in contact, or several equal ones.
    struct Touch
    {
        TouchPlace place;
        double force_N = 0.0;
        double depth_mm = 0.0;
        double time_s = 0.0; ///< time of the tick, ascending
        double dt_s = 0.0;   ///< duration, for example 1e-3
    };
    /// Adds a tick in contact.
    /// @return the nearest original vertex; empty if there is none within the distance
    /// @par Cost proportional to the number of vertices within about the distance, for a ball within about the distance
    /// and the radius
    std::optional<std::uint32_t> add(const Touch& touch);

    /// Split mesh; the original vertices come first.
    [[nodiscard]] const geometry::TriangleMesh& mesh() const noexcept { return m_mesh; }
    /// Time that the contact was within the distance of each vertex [s].
    [[nodiscard]] const std::vector<double>& dwell_s() const noexcept { return m_dwell_s; }
    /// Maximum force during that time [N].
    [[nodiscard]] const std::vector<double>& peakForce_N() const noexcept { return m_peakForce_N; }
    /// Mean force during that time [N]; 0 where never touched.
    [[nodiscard]] std::vector<double> meanForce_N() const;
    /// Maximum depth of the hand below the surface during that time [mm].
    [[nodiscard]] const std::vector<double>& peakDepth_mm() const noexcept { return m_peakDepth_mm; }
    /// Largest ratio of force and depth of the ticks at least core::kMinStiffnessDepth_mm deep [N/mm]; 0: never that
    /// deep.
    [[nodiscard]] const std::vector<double>& stiffness_N_per_mm() const noexcept { return m_stiffness_N_per_mm; }
    /// Number of times that the contact came within the distance.
    [[nodiscard]] const std::vector<std::uint32_t>& visits() const noexcept { return m_visits; }
    /// Number of original vertices.
    [[nodiscard]] std::size_t givenVertices() const noexcept { return m_given; }
    /// Area share of each vertex [mm²].
    [[nodiscard]] const std::vector<double>& share_mm2() const noexcept { return m_share_mm2; }
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
    void count(std::uint32_t vertex, const Touch& touch);
    [[nodiscard]] Cell cellOf(const core::Vec3& p) const;

    double m_distance_mm;
    std::size_t m_given;
    geometry::TriangleMesh m_mesh;
    std::vector<double> m_share_mm2;
    std::vector<double> m_dwell_s;
    std::vector<double> m_peakForce_N;
    std::vector<double> m_impulse_Ns; ///< force times duration, summed
    std::vector<double> m_peakDepth_mm;
    std::vector<double> m_stiffness_N_per_mm;
    std::vector<double> m_last_s; ///< end of the last touch
    std::vector<std::uint32_t> m_visits;
    double m_area_mm2 = 0.0;
    std::vector<std::uint32_t> m_order;                                                  ///< vertices, grouped by cell
    std::unordered_map<Cell, std::pair<std::uint32_t, std::uint32_t>, CellHash> m_cells; ///< range in m_order
};

/// Returns the end of the colours of a map of touch: the 98th percentile of the touched places, rounded up to 1, 2 or 5
/// times a power of ten. 1 without touched places.
/// @param values  of all places; untouched ones are 0 or NaN
[[nodiscard]] PALPATE_EXPORT double mapEnd(const std::vector<float>& values);

} // namespace palpate::session
