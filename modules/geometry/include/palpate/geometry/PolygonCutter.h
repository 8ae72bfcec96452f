// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/TriangleMesh.h"

#include <palpate/core/Export.h>

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace palpate::geometry {

/// Triangulates polygons, including concave polygons, by ear clipping. A vertex in the middle of a straight side
/// remains a corner of a triangle, so that no gap opens to neighbours that share this vertex.
///
/// VTK's triangulation fails for polygons with such vertices and for small polygons in metres.
class PALPATE_EXPORT PolygonCutter
{
  public:
    static constexpr std::size_t kMostCorners = 1024; ///< ear clipping takes cubic time at worst

    /// Appends `corners.size() - 2` triangles to `out`, wound as the polygon is.
    /// @param corners  3 to kMostCorners indices into `points`
    void cut(const std::vector<Vec3>& points, std::span<const std::uint32_t> corners, std::vector<Triangle>& out);

    /// Number of polygons without a simple outline; the triangulation of these is arbitrary.
    [[nodiscard]] std::uint64_t crossing() const noexcept { return m_crossing; }

  private:
    void project(const std::vector<Vec3>& points, std::span<const std::uint32_t> corners);
    [[nodiscard]] bool isEar(std::size_t i) const;
    [[nodiscard]] double turnAt(std::size_t i) const;

    std::vector<Eigen::Vector2d> m_flat; ///< corners in the polygon's plane, counter-clockwise
    std::vector<std::uint32_t> m_left;   ///< corners not yet cut off, into m_flat
    std::uint64_t m_crossing = 0;
};

} // namespace palpate::geometry
