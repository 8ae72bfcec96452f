// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace palpate::evaluation {

using Long3 = Eigen::Matrix<long double, 3, 1>;

/// Exact sign of the volume det(b - a, c - a, d - a): +1 if d is in front of the triangle a, b, c (counter-clockwise
/// seen from d), 0 if the four points are coplanar.
///
/// Evaluates in long double with a bound on the rounding error; if the sign is uncertain, repeats the computation
/// exactly with expansions of doubles.
/// @par Source Shewchuk, Adaptive Precision Floating-Point Arithmetic, Discrete Comput. Geom. 18 (1997),
/// doi:10.1007/PL00009321: expansion arithmetic. Difference: a single filter before the exact computation, without
/// intermediate stages.
[[nodiscard]] int orientation(const Long3& a, const Long3& b, const Long3& c, const Long3& d);

} // namespace palpate::evaluation
