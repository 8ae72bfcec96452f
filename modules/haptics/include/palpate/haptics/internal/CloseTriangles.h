// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/internal/GatheredFacets.h"
#include "palpate/haptics/internal/TriangleDistances.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace palpate::haptics::internal {

/// Of the facets gathered around a ball, those that it may touch as long as its centre stays near the way it is on:
/// most moves are short and are asked of these alone. They never change an answer, only what it costs.
class CloseTriangles
{
  public:
    using Facets = GatheredFacets<TriangleGroup, kMostTriangles>;

    /// Forgets everything: the scene changed.
    void clear() noexcept { *this = {}; }

    /// Takes what is close to a move and to the way of the next ticks.
    /// @param held          complete in its region
    /// @param x,y           of the ball's centre [mm]
    /// @param motion        of it in a tick [mm]
    /// @param facetSize_mm  what to begin with as the distance from the way
    /// @return false when that isn't known, or is too much
    bool take(const Facets& held, const Vec3& x, const Vec3& y, const Vec3& motion, double radius_mm,
              double facetSize_mm) noexcept PALPATE_NONBLOCKING;

    /// @return true when no facet is missing that a ball may touch whose centre is at `p`.
    [[nodiscard]] bool covers(const Vec3& p) const noexcept
    {
        const Vec3 q = p - m_from;
        const double share = m_way2 > 0.0 ? std::clamp(q.dot(m_way) / m_way2, 0.0, 1.0) : 0.0;
        return m_reach_mm >= 0.0 && (q - share * m_way).squaredNorm() <= m_reach_mm * m_reach_mm;
    }

    [[nodiscard]] const Vec3& origin() const noexcept { return m_origin; } ///< of the groups [mm]
    [[nodiscard]] int count() const noexcept { return m_count; }
    [[nodiscard]] float reach_mm() const noexcept { return m_coordinate_mm; } ///< largest coordinate in the groups
    [[nodiscard]] const TriangleGroup* groups() const noexcept { return m_groups.data(); }
    [[nodiscard]] std::uint32_t structure(int i) const noexcept { return m_structure[static_cast<std::size_t>(i)]; }
    [[nodiscard]] std::uint32_t triangle(int i) const noexcept { return m_triangle[static_cast<std::size_t>(i)]; }

  private:
    static constexpr std::size_t kMost = 48;

    Vec3 m_from = Vec3::Zero(); ///< where the way begins [mm]
    Vec3 m_way = Vec3::Zero();  ///< [mm]
    double m_way2 = 0.0;        ///< its length squared
    double m_reach_mm = -1.0;   ///< around the way; negative: nothing is known
    double m_wanted_mm = 0.0;   ///< reach to try next; 0: not known yet
    Vec3 m_origin = Vec3::Zero();
    float m_coordinate_mm = 0.0f;
    int m_count = 0;
    std::array<TriangleGroup, kMost / kLanes> m_groups{};
    std::array<std::uint32_t, kMost> m_structure{};
    std::array<std::uint32_t, kMost> m_triangle{};
};

} // namespace palpate::haptics::internal
