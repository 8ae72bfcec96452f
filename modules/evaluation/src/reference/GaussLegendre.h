// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace palpate::evaluation {

/// Nodes and weights of a quadrature rule.
struct Quadrature
{
    std::vector<double> at, weight;
};

/// Gauss-Legendre rule on an interval, exact for polynomials up to degree 2 n - 1. @param n  >= 1
[[nodiscard]] Quadrature gaussLegendre(int n, double low, double high);

} // namespace palpate::evaluation
