// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/HapticScene.h"

#include <algorithm>
#include <array>

namespace palpate::haptics::law {

/// What a map says at a place of a triangle: linear between its corners, so that the gradient is constant there.
struct MapValue
{
    double value = 1.0;
    Vec3 gradient = Vec3::Zero(); ///< in the triangle's plane [1/mm times the value's unit]
};

/// A place on a triangle by its barycentric coordinates: the same for all maps.
/// @par Real-time Wait-free.
class MapPlace
{
  public:
    /// @param triangle  position in the SurfaceIndex; @param corners  of it [mm]
    /// @param p  a place; beyond an edge the value is that of the nearest place in barycentric coordinates
    /// @pre the triangle has an area, as those of an index do
    MapPlace(std::uint32_t triangle, const std::array<Vec3, 3>& corners, const Vec3& p) noexcept
        : m_triangle(triangle)
    {
        const Vec3 e1 = corners[1] - corners[0], e2 = corners[2] - corners[0];
        const Vec3 across = e1.cross(e2);
        const double area2 = across.squaredNorm();
        m_toSecond = e2.cross(across) / area2;
        m_toThird = across.cross(e1) / area2;
        const Vec3 from = p - corners[0];
        m_b1 = std::clamp(m_toSecond.dot(from), 0.0, 1.0);
        m_b2 = std::clamp(m_toThird.dot(from), 0.0, 1.0 - m_b1);
    }

    /// A map's value, and how it rises from the first corner to the second and to the third.
    struct Rises
    {
        double value, toSecond, toThird;
    };
    [[nodiscard]] Rises risesOf(const TissueMap& map) const noexcept
    {
        const std::array<float, 3>& at = (*map.corners)[m_triangle];
        const double d1 = map.factor * (double{at[1]} - double{at[0]}),
                     d2 = map.factor * (double{at[2]} - double{at[0]});
        return {map.factor * double{at[0]} + m_b1 * d1 + m_b2 * d2, d1, d2};
    }
    [[nodiscard]] Vec3 gradientOf(double toSecond, double toThird) const noexcept
    {
        return toSecond * m_toSecond + toThird * m_toThird;
    }
    [[nodiscard]] MapValue valueOf(const TissueMap& map) const noexcept
    {
        const Rises rises = risesOf(map);
        return {rises.value, gradientOf(rises.toSecond, rises.toThird)};
    }

  private:
    std::uint32_t m_triangle;
    Vec3 m_toSecond, m_toThird; ///< gradients of the second and the third barycentric coordinate [1/mm]
    double m_b1, m_b2;
};

} // namespace palpate::haptics::law
