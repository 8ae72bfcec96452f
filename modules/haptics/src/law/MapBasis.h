// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "probe/PointProbe.h"

#include <array>

namespace palpate::haptics::law {

/// How much each of a triangle's six bends (TissueMap::bends) counts at a place.
/// @par Real-time Wait-free.
class MapBasis
{
  public:
    /// A number there, and how it rises from the first corner to the second and to the third.
    struct Rises
    {
        double value, toSecond, toThird;
    };

    MapBasis() = default; // for one that is set later
    /// @param b1, b2  barycentric coordinates of the second corner and of the third
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
