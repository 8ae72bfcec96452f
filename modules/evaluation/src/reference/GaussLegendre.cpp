// SPDX-License-Identifier: BSD-3-Clause
#include "reference/GaussLegendre.h"

#include <cmath>
#include <numbers>

namespace palpate::evaluation {

Quadrature gaussLegendre(int n, double low, double high)
{
    Quadrature rule;
    const double half = 0.5 * (high - low), middle = 0.5 * (high + low);
    for (int i = 0; i < n; ++i) {
        // Newton's method on the Legendre polynomial, starting from an approximation of the i-th root.
        double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5)), slope = 1.0;
        for (int step = 0; step < 20; ++step) {
            double before = 1.0, value = x;
            for (int k = 2; k <= n; ++k) {
                const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
                before = value;
                value = next;
            }
            slope = n * (x * value - before) / (x * x - 1.0);
            const double move = value / slope;
            x -= move;
            if (std::abs(move) < 1e-15) {
                break;
            }
        }
        rule.at.push_back(middle + half * x);
        rule.weight.push_back(half * 2.0 / ((1.0 - x * x) * slope * slope));
    }
    return rule;
}

} // namespace palpate::evaluation
