// SPDX-License-Identifier: BSD-3-Clause
#include "law/MapBasis.h"

#include <algorithm>
#include <cstddef>

namespace palpate::haptics::law {

namespace {

/// Value of a polynomial at barycentric coordinates, and its derivatives by each of them.
struct Term
{
    double value = 0.0;
    std::array<double, 3> by{};

    void add(double share, const Term& other) noexcept
    {
        value += share * other.value;
        for (std::size_t i = 0; i < by.size(); ++i) {
            by[i] += share * other.by[i];
        }
    }
    [[nodiscard]] MapBasis::Rises rises() const noexcept { return {value, by[1] - by[0], by[2] - by[0]}; }
};

/// `3 b_i^2 b_j`, the Bernstein polynomial of the control value on edge ij next to corner i.
Term ofEdge(const std::array<double, 3>& b, std::size_t i, std::size_t j) noexcept
{
    Term term{3.0 * b[i] * b[i] * b[j], {}};
    term.by[i] = 6.0 * b[i] * b[j];
    term.by[j] = 3.0 * b[i] * b[i];
    return term;
}

/// `6 b_0 b_1 b_2 w_k`, where w_k = b_i b_j / (b_1 b_2 + b_2 b_0 + b_0 b_1) is the weight of edge ij, opposite to
/// corner k, in the middle control value; w_k is 1 on that edge.
Term ofMiddle(const std::array<double, 3>& b, std::size_t k) noexcept
{
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const double pairs = b[1] * b[2] + b[2] * b[0] + b[0] * b[1];
    if (!(pairs > 0.0)) {
        return {}; // at a corner
    }
    const double perPairs = 6.0 / pairs, across = b[i] * b[j];
    Term term{perPairs * b[k] * across * across, {}};
    const double less = term.value / pairs;
    term.by[k] = perPairs * across * across - less * (b[i] + b[j]);
    term.by[i] = perPairs * 2.0 * b[k] * across * b[j] - less * (b[j] + b[k]);
    term.by[j] = perPairs * 2.0 * b[k] * across * b[i] - less * (b[i] + b[k]);
    return term;
}

} // namespace

MapBasis::MapBasis(const internal::Facet& facet, double b1, double b2) noexcept
{
    const std::array<double, 3> b{std::max(0.0, 1.0 - b1 - b2), b1, b2};
    const std::array<const core::Vec3*, 3> corner{&facet.a, &facet.b, &facet.c};
    const std::array<Term, 3> middle{ofMiddle(b, 0), ofMiddle(b, 1), ofMiddle(b, 2)};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        // The foot of the altitude on edge ij has the barycentric weights `foot` of corner i and 1 - foot of corner j.
        // These weights of the middle control value make the slope across the edge linear along the edge (Farin,
        // section on C1 of Bezier triangles).
        const core::Vec3 along = *corner[j] - *corner[i];
        const double foot = (*corner[j] - *corner[k]).dot(along) / along.squaredNorm();
        // For obtuse triangles: maximum distance beyond the ends of the edge, in edge lengths.
        constexpr double kBeside = 1.0;
        const double toI = std::clamp(foot, -kBeside, 1.0 + kBeside);
        Term atStart = ofEdge(b, i, j), atEnd = ofEdge(b, j, i);
        atStart.add(1.5 * toI - 0.5, middle[k]);
        atStart.add(0.5, middle[j]);
        atEnd.add(1.0 - 1.5 * toI, middle[k]);
        atEnd.add(0.5, middle[i]);
        m_of[2 * i] = atStart.rises();
        m_of[2 * i + 1] = atEnd.rises();
    }
}

} // namespace palpate::haptics::law
