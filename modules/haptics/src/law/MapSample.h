// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "law/MapBends.h"
#include "palpate/haptics/HapticScene.h"
#include "probe/BallProbe.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace palpate::haptics::law {

/// Value and gradient of a map at a point of a triangle.
struct MapSample
{
    double value = 1.0;
    Vec3 gradient = Vec3::Zero(); ///< in the triangle's plane [unit of the value / mm]
};

/// Gradient of linear functions on a triangle, shared by all maps.
/// @par Real-time Wait-free.
class FacetSlopes
{
  public:
    /// @param facet  a triangle with nonzero area, as guaranteed by an index
    explicit FacetSlopes(const internal::Facet& facet) noexcept
    {
        const Vec3 e1 = facet.b - facet.a, e2 = facet.c - facet.a;
        const Vec3 across = e1.cross(e2);
        m_perArea2 = 1.0 / across.squaredNorm();
        m_toSecond = e2.cross(across);
        m_toThird = across.cross(e1);
    }

    /// Returns the gradient of a linear function.
    /// @param toSecond,toThird  differences from the first corner to the second and to the third
    [[nodiscard]] Vec3 gradientOf(double toSecond, double toThird) const noexcept
    {
        return m_perArea2 * (toSecond * m_toSecond + toThird * m_toThird);
    }
    /// Returns the barycentric coordinate of the second corner (`second`) or the third (`third`).
    /// @param from  vector from the first corner to the position [mm]
    [[nodiscard]] double second(const Vec3& from) const noexcept { return m_toSecond.dot(from) * m_perArea2; }
    [[nodiscard]] double third(const Vec3& from) const noexcept { return m_toThird.dot(from) * m_perArea2; }

  private:
    Vec3 m_toSecond, m_toThird; ///< gradients of the two coordinates, times the squared double area [mm^3]
    double m_perArea2;          ///< 1 / squared double area [1/mm^4]
};

/// A position on a triangle in barycentric coordinates.
/// @par Real-time Wait-free.
class MapPlace
{
  public:
    /// @param facet  the triangle
    /// @param p  position; its height above the triangle is ignored, and a position beyond an edge is projected onto
    /// the edge
    MapPlace(const internal::Facet& facet, const Vec3& p) noexcept
        : m_facet(facet)
        , m_slopes(facet)
    {
        const Vec3 from = p - facet.a;
        m_b1 = m_slopes.second(from);
        m_b2 = m_slopes.third(from);
        if (!(m_b1 >= 0.0 && m_b2 >= 0.0 && m_b1 + m_b2 <= 1.0)) {
            const Vec3 nearest = internal::nearestOn(facet, p).q - facet.a;
            m_b1 = std::clamp(m_slopes.second(nearest), 0.0, 1.0);
            m_b2 = std::clamp(m_slopes.third(nearest), 0.0, 1.0 - m_b1);
        }
    }

    using Rises = MapBends::Rises;
    [[nodiscard]] Rises risesOf(const TissueMap& map) const noexcept
    {
        const Rises linear = linearOf(map);
        if (!bends(map)) {
            return linear;
        }
        const Rises more = m_bends.of((*map.bends)[m_facet.triangle]);
        const Rises bent{linear.value + map.factor * more.value, linear.toSecond + map.factor * more.toSecond,
                         linear.toThird + map.factor * more.toThird};
        return bent.value > 0.0 ? bent : linear; // keeps the stiffness positive even for steep maps
    }
    /// Computes only the value of `risesOf`, bitwise identical.
    [[nodiscard]] double numberOf(const TissueMap& map) const noexcept
    {
        const double linear = linearOf(map).value;
        if (!bends(map)) {
            return linear;
        }
        const double bent = linear + map.factor * m_bends.valueOf((*map.bends)[m_facet.triangle]);
        return bent > 0.0 ? bent : linear;
    }
    [[nodiscard]] const FacetSlopes& slopes() const noexcept { return m_slopes; }
    [[nodiscard]] MapSample valueOf(const TissueMap& map) const noexcept
    {
        const Rises rises = risesOf(map);
        return {rises.value, m_slopes.gradientOf(rises.toSecond, rises.toThird)};
    }

  private:
    [[nodiscard]] Rises linearOf(const TissueMap& map) const noexcept
    {
        const std::array<float, 3>& at = (*map.corners)[m_facet.triangle];
        const double d1 = map.factor * (double{at[1]} - double{at[0]}),
                     d2 = map.factor * (double{at[2]} - double{at[0]});
        return {map.factor * double{at[0]} + m_b1 * d1 + m_b2 * d2, d1, d2};
    }
    /// Returns true if the map bends on the triangle; m_bends is then computed.
    [[nodiscard]] bool bends(const TissueMap& map) const noexcept
    {
        if (map.bends == nullptr || !map.bendsOn(m_facet.triangle)) {
            return false;
        }
        if (!m_hasBends) {
            m_bends = MapBends(m_facet, m_b1, m_b2);
            m_hasBends = true;
        }
        return true;
    }

    const internal::Facet& m_facet;
    FacetSlopes m_slopes;
    double m_b1, m_b2;
    mutable MapBends m_bends; ///< shared by all maps; computed when the first map with bends is evaluated
    mutable bool m_hasBends = false;
};

} // namespace palpate::haptics::law
