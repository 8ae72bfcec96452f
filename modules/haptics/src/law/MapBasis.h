// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "probe/PointProbe.h"

#include <array>

namespace palpate::haptics::law {

/// Basis functions of a triangle's six bends (TissueMap::bends) at a position.
/// @par Real-time Wait-free.
class MapBasis
{
  public:
    /// A value and its differences from the first corner to the second and to the third.
    struct Rises
    {
        double value, toSecond, toThird;
    };

    MapBasis() = default; // uninitialized, to be assigned later
    /// @param facet  the triangle
    /// @param b1,b2  barycentric coordinates of the second and the third corner
    MapBasis(const internal::Facet& facet, double b1, double b2) noexcept;

    [[nodiscard]] Rises sum(const std::array<float, 6>& bends) const noexcept
    {
        Rises sum{0.0, 0.0, 0.0};
        for (std::size_t i = 0; i < bends.size(); ++i) {
            const double by = double{bends[i]};
            sum.value += by * m_of[i].value;
            sum.toSecond += by * m_of[i].toSecond;
            sum.toThird += by * m_of[i].toThird;
        }
        return sum;
    }

  private:
    std::array<Rises, 6> m_of;
};

} // namespace palpate::haptics::law
