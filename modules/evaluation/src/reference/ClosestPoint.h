// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>

namespace palpate::evaluation {

/// @return the point of the closed triangle a, b, c closest to `p`: the foot in its plane, or a point on an edge.
template<class T>
[[nodiscard]] Eigen::Matrix<T, 3, 1> closestPoint(const Eigen::Matrix<T, 3, 1>& a, const Eigen::Matrix<T, 3, 1>& b,
                                                  const Eigen::Matrix<T, 3, 1>& c, const Eigen::Matrix<T, 3, 1>& p)
{
    using V = Eigen::Matrix<T, 3, 1>;
    const V n = (b - a).cross(c - a);
    const auto isInside = [&](const V& u, const V& v) { return n.dot((v - u).cross(p - u)) >= 0; };
    if (isInside(a, b) && isInside(b, c) && isInside(c, a)) {
        return p - n * (n.dot(p - a) / n.squaredNorm());
    }
    V best = a;
    const auto offer = [&](const V& u, const V& v) {
        const V edge = v - u;
        const T length2 = edge.squaredNorm();
        const T share = length2 > 0 ? std::clamp(edge.dot(p - u) / length2, T(0), T(1)) : T(0);
        const V q = u + share * edge;
        if ((q - p).squaredNorm() < (best - p).squaredNorm()) {
            best = q;
        }
    };
    offer(a, b);
    offer(b, c);
    offer(c, a);
    return best;
}

} // namespace palpate::evaluation
