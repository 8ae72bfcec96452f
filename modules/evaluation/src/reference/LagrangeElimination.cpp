// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/LagrangeElimination.h"

namespace palpate::evaluation {

namespace {

/// Number that counts the multiplications and divisions applied to it.
struct Counted
{
    double value = 0.0;
    int* count = nullptr;

    friend Counted operator+(Counted a, Counted b) { return {a.value + b.value, a.count}; }
    friend Counted operator-(Counted a, Counted b) { return {a.value - b.value, a.count}; }
    friend Counted operator*(Counted a, Counted b) { return {(++*a.count, a.value * b.value), a.count}; }
    friend Counted operator/(Counted a, Counted b) { return {(++*a.count, a.value / b.value), a.count}; }
};

} // namespace

Elimination eliminate(const Vec3& hip, std::span<const Plane> planes)
{
    Elimination result;
    int* count = &result.multiplicativeOperations;
    const std::size_t k = planes.size();
    std::array<std::array<Counted, 3>, 3> n;
    std::array<Counted, 3> h;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        h[axis] = {hip[static_cast<Eigen::Index>(axis)], count};
        for (std::size_t i = 0; i < k; ++i) {
            n[i][axis] = {planes[i].n[static_cast<Eigen::Index>(axis)], count};
        }
    }
    // Subtracting N times the identity rows from the rows of N leaves -N N^T (of which one triangle is computed)
    // and d - N hip.
    std::array<std::array<Counted, 3>, 3> s;
    std::array<Counted, 3> r;
    for (std::size_t i = 0; i < k; ++i) {
        for (std::size_t j = i; j < k; ++j) {
            s[i][j] = n[i][0] * n[j][0] + n[i][1] * n[j][1] + n[i][2] * n[j][2];
        }
        r[i] = n[i][0] * h[0] + n[i][1] * h[1] + n[i][2] * h[2] - Counted{planes[i].d, count};
    }
    // Solve the symmetric system s lambda = r.
    for (std::size_t i = 0; i < k; ++i) {
        if (s[i][i].value == 0.0) {
            return result;
        }
        for (std::size_t j = i + 1; j < k; ++j) {
            const Counted factor = s[i][j] / s[i][i];
            for (std::size_t m = j; m < k; ++m) {
                s[j][m] = s[j][m] - factor * s[i][m];
            }
            r[j] = r[j] - factor * r[i];
        }
    }
    std::array<Counted, 3> lambda;
    for (std::size_t i = k; i-- > 0;) {
        lambda[i] = r[i];
        for (std::size_t j = i + 1; j < k; ++j) {
            lambda[i] = lambda[i] - s[i][j] * lambda[j];
        }
        lambda[i] = lambda[i] / s[i][i];
        result.lambda[i] = lambda[i].value;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Counted x = h[axis];
        for (std::size_t i = 0; i < k; ++i) {
            x = x - n[i][axis] * lambda[i];
        }
        result.p[static_cast<Eigen::Index>(axis)] = x.value;
    }
    result.isSolved = result.p.allFinite();
    return result;
}

} // namespace palpate::evaluation
