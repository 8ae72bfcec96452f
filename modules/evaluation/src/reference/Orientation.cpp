// SPDX-License-Identifier: BSD-3-Clause
#include "reference/Orientation.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace palpate::evaluation {

namespace {

/// Number represented as a sum of non-overlapping doubles in ascending order; all operations are exact.
class Expansion
{
  public:
    Expansion() = default;
    explicit Expansion(long double x)
    {
        const auto high = static_cast<double>(x);
        const auto low = static_cast<double>(x - static_cast<long double>(high)); // 64 bits fit into two doubles
        add(low);
        add(high);
    }

    void add(double b)
    {
        // Grow-expansion: carry the sum through the terms and keep each exact rounding error.
        std::vector<double> grown;
        grown.reserve(m_terms.size() + 1);
        for (const double e : m_terms) {
            const double sum = b + e;
            const double part = sum - b;
            const double error = (b - (sum - part)) + (e - part);
            if (error != 0.0) {
                grown.push_back(error);
            }
            b = sum;
        }
        if (b != 0.0) {
            grown.push_back(b);
        }
        m_terms = std::move(grown);
    }

    friend Expansion operator+(const Expansion& x, const Expansion& y)
    {
        Expansion sum = x;
        for (const double term : y.m_terms) {
            sum.add(term);
        }
        return sum;
    }
    friend Expansion operator-(const Expansion& x, const Expansion& y)
    {
        Expansion difference = x;
        for (const double term : y.m_terms) {
            difference.add(-term);
        }
        return difference;
    }
    friend Expansion operator*(const Expansion& x, const Expansion& y)
    {
        Expansion product;
        for (const double a : x.m_terms) {
            for (const double b : y.m_terms) {
                const double high = a * b;
                product.add(std::fma(a, b, -high));
                product.add(high);
            }
        }
        return product;
    }
    [[nodiscard]] int sign() const { return m_terms.empty() ? 0 : m_terms.back() > 0.0 ? 1 : -1; }

  private:
    std::vector<double> m_terms;
};

int exactOrientation(const Long3& a, const Long3& b, const Long3& c, const Long3& d)
{
    std::array<std::array<Expansion, 3>, 3> m;
    const std::array<const Long3*, 3> rows{&b, &c, &d};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<Eigen::Index>(axis);
            m[i][axis] = Expansion((*rows[i])[k]) - Expansion(a[k]);
        }
    }
    const auto minor = [&m](std::size_t x, std::size_t y) { return m[1][x] * m[2][y] - m[1][y] * m[2][x]; };
    return (m[0][0] * minor(1, 2) + m[0][1] * minor(2, 0) + m[0][2] * minor(0, 1)).sign();
}

} // namespace

int orientation(const Long3& a, const Long3& b, const Long3& c, const Long3& d)
{
    const Long3 u = b - a, v = c - a, w = d - a;
    const long double volume = u.dot(v.cross(w));
    // Each of the six products has at most 6 rounding steps of half an ulp; 16 includes a margin for the sum of
    // magnitudes.
    const Long3 au = u.cwiseAbs(), av = v.cwiseAbs(), aw = w.cwiseAbs();
    const long double magnitude = au[0] * (av[1] * aw[2] + av[2] * aw[1]) + au[1] * (av[2] * aw[0] + av[0] * aw[2]) +
                                  au[2] * (av[0] * aw[1] + av[1] * aw[0]);
    const long double bound = 16 * std::numeric_limits<long double>::epsilon() * magnitude;
    if (volume > bound) {
        return 1;
    }
    if (volume < -bound) {
        return -1;
    }
    return magnitude == 0 ? 0 : exactOrientation(a, b, c, d);
}

} // namespace palpate::evaluation
