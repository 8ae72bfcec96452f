// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "probe/PointProbe.h"

#include <palpate/core/Realtime.h>

#include <array>

namespace palpate::haptics::law {

/// Evaluates the bends of maps (TissueMap::bends) at a position on a triangle.
///
/// Bends are the control values of a cubic Bezier triangle next to its corners, above the linear map. The middle
/// control value is rational, so that the slope across each edge is linear along the edge and the gradient is
/// continuous. With the barycentric coordinates b, x_ij the bend on edge ij next to corner i, and the edges' weights
/// q_k = b_i b_j:
///
///     sum over edges ij of 3 b_i b_j (b_i x_ij + b_j x_ji)  +  6 b_0 b_1 b_2 (sum q_k c_k) / (sum q_k)
///
/// where c_k, the middle control value wanted by edge ij, contains the foot of the altitude on this edge.
/// @par Source resources/docs/maps.md; Farin, Curves and Surfaces for CAGD, section on C1 of Bezier triangles.
/// @par Real-time Wait-free.
class MapBends
{
  public:
    /// A value and its differences from the first corner to the second and to the third.
    struct Rises
    {
        double value, toSecond, toThird;
    };

    MapBends() = default; // uninitialized, to be assigned later
    /// @param facet  the triangle
    /// @param b1,b2  barycentric coordinates of the second and the third corner
    MapBends(const internal::Facet& facet, double b1, double b2) noexcept;

    /// @param bends  of a map on the triangle: x_01, x_10, x_12, x_21, x_20, x_02
    [[nodiscard]] Rises of(const std::array<float, 6>& bends) const noexcept;
    /// Computes only the value, bitwise identical.
    [[nodiscard]] double valueOf(const std::array<float, 6>& bends) const noexcept;

  private:
    /// Parts of the value: per edge, the control values weighted by the ends; per corner, c_k; the mean of these.
    struct Sums
    {
        double s01, s12, s20, c0, c1, c2, c, value;
    };
    [[nodiscard]] PALPATE_ALWAYS_INLINE Sums sumsOf(const std::array<float, 6>& bends) const noexcept;

    std::array<double, 3> m_b;        ///< barycentric coordinates
    std::array<double, 3> m_opposite; ///< q_k: product of the other two coordinates
    std::array<double, 3> m_foot;     ///< of the altitude on edge 01, 12, 20: weight of the edge's first corner
    double m_perSum;                  ///< 1 / sum of q; 0 at a corner
};

} // namespace palpate::haptics::law
