// SPDX-License-Identifier: BSD-3-Clause
#include "probe/ConstrainedPoint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate::haptics::internal {

namespace {

// Normals closer to linear dependence than this have lost half of their digits to rounding, and the set is skipped.
constexpr double kIndependent = 1.5e-8;

/// Indices of planes. The count is a compile-time constant, so that the loops are unrolled completely: the cases of one
/// and two planes become closed forms.
template<std::size_t k>
using PlaneSet = std::array<std::uint8_t, k>;

/// Solves with equality on `set`.
/// @return false if the normals are dependent or a multiplier is not positive
template<std::size_t k>
PALPATE_ALWAYS_INLINE bool solveOn(const Vec3& wanted, std::span<const HalfSpace> planes, const PlaneSet<k>& set,
                                   Vec3& u, std::array<double, 3>& lambda) noexcept
{
    std::array<Vec3, k> e; // orthonormal directions: planes[set[i]].n = sum over j <= i of l[i][j] e[j]
    std::array<std::array<double, k>, k> l{};
    std::array<double, k> mu; // u = wanted + sum of mu[j] e[j]
    u = wanted;
    for (std::size_t i = 0; i < k; ++i) {
        const Vec3& n = planes[set[i]].n;
        e[i] = n;
        // Second pass to remove the rounding error of the first.
        for (int pass = 0; pass < (i == 0 ? 0 : 2); ++pass) {
            for (std::size_t j = 0; j < i; ++j) {
                const double along = e[i].dot(e[j]);
                l[i][j] += along;
                e[i] -= along * e[j];
            }
        }
        l[i][i] = i == 0 ? 1.0 : e[i].norm();
        if (l[i][i] < kIndependent) {
            return false;
        }
        e[i] /= l[i][i];
        // n . u = offset, with the earlier directions already in u.
        mu[i] = (planes[set[i]].offset_mm - n.dot(u)) / l[i][i];
        u += mu[i] * e[i];
    }
    // Multipliers: sum of lambda[i] n[i] = sum of mu[j] e[j], so L^T lambda = mu.
    for (std::size_t i = k; i-- > 0;) {
        lambda[i] = mu[i];
        for (std::size_t j = i + 1; j < k; ++j) {
            lambda[i] -= l[j][i] * lambda[j];
        }
        lambda[i] /= l[i][i];
        if (!(lambda[i] > 0.0)) {
            return false;
        }
    }
    return true;
}

template<std::size_t k>
double worstViolation(const Vec3& u, std::span<const HalfSpace> planes, const PlaneSet<k>& set) noexcept
{
    double worst = 0.0;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        if (std::find(set.begin(), set.end(), static_cast<std::uint8_t>(i)) == set.end()) {
            worst = std::max(worst, planes[i].offset_mm - planes[i].n.dot(u));
        }
    }
    return worst;
}

} // namespace

ConstrainedPoint constrainedPoint(const Vec3& wanted, std::span<const HalfSpace> halfSpaces,
                                  double allowance_mm) noexcept
{
    ConstrainedPoint best;
    best.u = wanted;
    if (halfSpaces.size() == 1) { // single face, the most frequent case
        const double missing = halfSpaces[0].offset_mm - halfSpaces[0].n.dot(wanted);
        if (missing > allowance_mm) {
            best.u += missing * halfSpaces[0].n;
            best.lambda_mm[0] = missing;
            best.count = 1;
        }
        return best;
    }
    double least = worstViolation(wanted, halfSpaces, PlaneSet<0>{});
    if (least <= allowance_mm) {
        return best;
    }
    const auto n = static_cast<std::uint8_t>(halfSpaces.size());
    const auto attempt = [&]<std::size_t k>(const PlaneSet<k>& set) {
        Vec3 u;
        std::array<double, 3> lambda;
        if (!solveOn(wanted, halfSpaces, set, u, lambda)) {
            return false;
        }
        const double violation = worstViolation(u, halfSpaces, set);
        if (violation < least || violation <= allowance_mm) {
            least = violation;
            best.u = u;
            best.count = static_cast<int>(set.size());
            std::copy(set.begin(), set.end(), best.active.begin());
            best.lambda_mm = lambda;
        }
        return violation <= allowance_mm;
    };
    for (std::uint8_t i = 0; i < n; ++i) {
        if (attempt(PlaneSet<1>{i})) {
            return best;
        }
    }
    for (std::uint8_t i = 0; i < n; ++i) {
        for (auto j = static_cast<std::uint8_t>(i + 1); j < n; ++j) {
            if (attempt(PlaneSet<2>{i, j})) {
                return best;
            }
        }
    }
    for (std::uint8_t i = 0; i < n; ++i) {
        for (auto j = static_cast<std::uint8_t>(i + 1); j < n; ++j) {
            for (auto k = static_cast<std::uint8_t>(j + 1); k < n; ++k) {
                if (attempt(PlaneSet<3>{i, j, k})) {
                    return best;
                }
            }
        }
    }
    return best;
}

Vec3 freePart(Vec3 v, std::span<const Vec3> normals) noexcept
{
    std::array<Vec3, 3> held; // orthonormal
    std::size_t count = 0;
    for (const Vec3& normal : normals) {
        Vec3 n = normal;
        for (std::size_t i = 0; i < count; ++i) {
            n -= held[i].dot(n) * held[i];
        }
        const double length = n.norm();
        if (length < kIndependent || count == held.size()) {
            continue;
        }
        held[count] = n / length;
        v -= held[count].dot(v) * held[count];
        ++count;
    }
    return v;
}

} // namespace palpate::haptics::internal
