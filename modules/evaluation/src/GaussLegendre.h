// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace palpate::evaluation {

/// Points and weights of a rule for an integral.
struct Quadrature
{
    std::vector<double> at, weight;
};

/// Gauss's rule between two limits, exact for polynomials up to degree 2 n - 1. @param n  >= 1
[[nodiscard]] Quadrature gaussLegendre(int n, double low, double high);

} // namespace palpate::evaluation
