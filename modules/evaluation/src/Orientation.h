// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace palpate::evaluation {

using Long3 = Eigen::Matrix<long double, 3, 1>;

/// Sign of the volume det(b - a, c - a, d - a), decided exactly: +1 when d is in front of the triangle a, b, c that is
/// counter-clockwise seen from there, 0 when the four points lie in one plane.
///
/// In long double with a bound on the rounding error; what the bound leaves open is computed without rounding, as sums
/// of doubles that do not overlap.
/// @par Source Shewchuk, Adaptive Precision Floating-Point Arithmetic, Discrete Comput. Geom. 18 (1997),
/// doi:10.1007/PL00009321: the arithmetic of expansions. Differs: one filter and then all digits, no stages between.
[[nodiscard]] int orientation(const Long3& a, const Long3& b, const Long3& c, const Long3& d);

} // namespace palpate::evaluation
