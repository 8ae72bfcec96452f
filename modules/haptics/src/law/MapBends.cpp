// SPDX-License-Identifier: BSD-3-Clause
#include "law/MapBends.h"

#include <algorithm>

namespace palpate::haptics::law {

MapBends::MapBends(const internal::Facet& facet, double b1, double b2) noexcept
    : m_b{std::max(0.0, 1.0 - b1 - b2), b1, b2}
    , m_opposite{m_b[1] * m_b[2], m_b[2] * m_b[0], m_b[0] * m_b[1]}
{
    const double sum = m_opposite[0] + m_opposite[1] + m_opposite[2];
    m_perSum = sum > 0.0 ? 1.0 / sum : 0.0;
    const core::Vec3 e01 = facet.b - facet.a, e12 = facet.c - facet.b, e20 = facet.a - facet.c;
    // For obtuse triangles: maximum distance beyond the ends of the edge, in edge lengths.
    constexpr double kBeside = 1.0;
    const auto footOn = [](const core::Vec3& edge, const core::Vec3& fromOpposite) {
        return std::clamp(fromOpposite.dot(edge) / edge.squaredNorm(), -kBeside, 1.0 + kBeside);
    };
    m_foot = {footOn(e01, -e12), footOn(e12, -e20), footOn(e20, -e01)};
}

MapBends::Sums MapBends::sumsOf(const std::array<float, 6>& bends) const noexcept
{
    const auto& [b0, b1, b2] = m_b;
    const auto& [q0, q1, q2] = m_opposite;
    const double x01{bends[0]}, x10{bends[1]}, x12{bends[2]}, x21{bends[3]}, x20{bends[4]}, x02{bends[5]};
    // The middle control value is the mean `c` of the values wanted by the edges opposite to each corner.
    const auto wanted = [](double foot, double start, double end, double beside) {
        return 1.5 * foot * (start - end) + end + 0.5 * (beside - start);
    };
    Sums sums{b0 * x01 + b1 * x10,
              b1 * x12 + b2 * x21,
              b2 * x20 + b0 * x02,
              wanted(m_foot[1], x12, x21, x20 + x10),
              wanted(m_foot[2], x20, x02, x01 + x21),
              wanted(m_foot[0], x01, x10, x12 + x02),
              0.0,
              0.0};
    sums.c = m_perSum * (q0 * sums.c0 + q1 * sums.c1 + q2 * sums.c2);
    sums.value = 3.0 * (q2 * sums.s01 + q0 * sums.s12 + q1 * sums.s20 + 2.0 * b0 * q0 * sums.c);
    return sums;
}

double MapBends::valueOf(const std::array<float, 6>& bends) const noexcept
{
    return sumsOf(bends).value;
}

MapBends::Rises MapBends::of(const std::array<float, 6>& bends) const noexcept
{
    const auto& [b0, b1, b2] = m_b;
    const auto& [q0, q1, q2] = m_opposite;
    const double x01{bends[0]}, x10{bends[1]}, x12{bends[2]}, x21{bends[3]}, x20{bends[4]}, x02{bends[5]};
    const Sums s = sumsOf(bends);
    const double slope = 2.0 * b0 * q0 * m_perSum, d0 = s.c0 - s.c, d1 = s.c1 - s.c, d2 = s.c2 - s.c;
    const double by0 = b1 * s.s01 + q2 * x01 + b2 * s.s20 + q1 * x02 + 2.0 * q0 * s.c + slope * (b2 * d1 + b1 * d2);
    const double by1 = b0 * s.s01 + q2 * x10 + b2 * s.s12 + q0 * x12 + 2.0 * q1 * s.c + slope * (b2 * d0 + b0 * d2);
    const double by2 = b1 * s.s12 + q0 * x21 + b0 * s.s20 + q1 * x20 + 2.0 * q2 * s.c + slope * (b1 * d0 + b0 * d1);
    return {s.value, 3.0 * (by1 - by0), 3.0 * (by2 - by0)};
}

} // namespace palpate::haptics::law
