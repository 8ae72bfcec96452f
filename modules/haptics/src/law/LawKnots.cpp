// SPDX-License-Identifier: BSD-3-Clause
#include "law/LawKnots.h"

#include <palpate/core/ForceLaw.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace palpate::haptics::law {

namespace {

using Knot = ForceTable::Knot;
using core::ForceLaw;

constexpr double kCells = ForceTable::kLawKnots - 1;
constexpr double kPerkPa = 1e-3; // 1 kPa = 1e-3 N/mm^2

/// A law with increasing slope.
struct Curve
{
    std::function<Knot(double depth_mm)> at;
    double steepest_N_per_mm; ///< the law continues linearly from the depth at which it reaches this slope
};

/// Returns the depth at which the curve reaches its maximum slope, limited to the reach of the table.
double straightFrom(const Curve& curve)
{
    double below = 0.0, above = ForceTable::kReach_mm;
    if (curve.at(above).slopeAfter <= curve.steepest_N_per_mm) {
        return above;
    }
    for (int halving = 0; halving < 100; ++halving) {
        const double middle = 0.5 * (below + above);
        (curve.at(middle).slopeAfter < curve.steepest_N_per_mm ? below : above) = middle;
    }
    return above;
}

/// Samples a curve.
/// @param depthAt  maps the fraction of the knots to a depth [mm], from 0 at 0 to `end_mm` at 1
/// @param cells    at least 1
std::vector<Knot> sampled(const Curve& curve, double end_mm, double cells, const std::function<double(double)>& depthAt)
{
    const auto count = static_cast<int>(std::clamp(std::floor(cells), 1.0, kCells));
    std::vector<Knot> knots;
    for (int i = 0; i < count; ++i) {
        knots.push_back(curve.at(depthAt(i / double(count))));
    }
    knots.push_back(curve.at(end_mm));
    knots.back().slopeAfter = knots.back().slopeBefore = std::min(knots.back().slopeBefore, curve.steepest_N_per_mm);
    return knots;
}

/// Returns a straight line, for a law that reaches its maximum slope within a few minimum cells.
std::vector<Knot> straight(double slope)
{
    return {{0.0, 0.0, slope, slope}};
}

/// F = k0/beta (e^(beta d) - 1), slope k0 e^(beta d). The error of the cubics grows with the fourth derivative, so that
/// knots at equal steps of e^(beta d / 4) distribute the error evenly.
/// @par Source Fung, Am. J. Physiol. 213 (1967), doi:10.1152/ajplegacy.1967.213.6.1532.
std::vector<Knot> exponential(const ForceLaw& law)
{
    const auto [k0, beta, steepest, unused4, unused5] = law.numbers;
    const Curve curve{[k0 = k0, beta = beta](double d) {
                          const double slope = k0 * std::exp(beta * d);
                          return Knot{d, k0 / beta * std::expm1(beta * d), slope, slope};
                      },
                      steepest};
    const double end_mm = straightFrom(curve), least = 4.0 * ForceTable::kLeastCell_mm;
    if (end_mm < least) {
        return straight(steepest);
    }
    const double range = std::expm1(0.25 * beta * end_mm);
    return sampled(curve, end_mm, end_mm / least,
                   [&, beta = beta](double share) { return 4.0 / beta * std::log1p(range * share); });
}

/// Samples a spherical indenter on soft tissue at equal steps of the square root of the depth, in which the force is a
/// polynomial.
std::vector<Knot> ball(const Curve& curve)
{
    const double end_mm = straightFrom(curve), least = 4.0 * ForceTable::kLeastCell_mm;
    if (end_mm < least) {
        return straight(curve.steepest_N_per_mm);
    }
    return sampled(curve, end_mm, std::sqrt(end_mm / least), [&](double share) { return end_mm * share * share; });
}

/// F = 16/9 E sqrt(R) d^1.5: Hertz's 4/3 E* with Poisson's ratio 1/2.
/// @par Source Johnson, Contact Mechanics (1985), section 4.2, after Hertz 1882.
double hertzForce(double young_kPa, double radius_mm, double d)
{
    return 16.0 / 9.0 * kPerkPa * young_kPa * std::sqrt(radius_mm) * d * std::sqrt(d);
}

std::vector<Knot> hertz(const ForceLaw& law)
{
    return ball({[E = law.numbers[0], R = law.numbers[1]](double d) {
                     const double force = hertzForce(E, R, d);
                     const double slope = d > 0.0 ? 1.5 * force / d : 0.0;
                     return Knot{d, force, slope, slope};
                 },
                 ForceLaw::kMaxSlope});
}

/// Hertz's force times 1 + a1 x + a2 x^2 + a3 x^3 + a4 x^4, x = sqrt(R d) / thickness.
/// @par Source Dimitriadis et al., Biophys. J. 82 (2002), doi:10.1016/S0006-3495(02)75620-8, equations 12 (bonded) and
/// 11 (not bonded), with Poisson's ratio 1/2.
std::vector<Knot> layer(const ForceLaw& law)
{
    const auto [E, R, thickness_mm, bonded, unused] = law.numbers;
    constexpr std::array<double, 5> kBonded{1.0, 1.133, 1.283, 0.769, 0.0975}, kLoose{1.0, 0.884, 0.781, 0.386, 0.0048};
    const auto at = [E = E, R = R, thickness_mm = thickness_mm, a = bonded != 0.0 ? kBonded : kLoose](double d) {
        const double half = hertzForce(E, R, d), x = std::sqrt(R * d) / thickness_mm;
        double force = 0.0, slope = 0.0, power = half; // term i is hertz * a_i x^i, of degree 1.5 + i/2 in d
        for (std::size_t i = 0; i < a.size(); ++i) {
            force += a[i] * power;
            slope += d > 0.0 ? a[i] * power * (1.5 + 0.5 * double(i)) / d : 0.0;
            power *= x;
        }
        return Knot{d, force, slope, slope};
    };
    return ball({at, ForceLaw::kMaxSlope});
}

/// Three line segments: up to F1, down to F2, and up again.
std::vector<Knot> click(const ForceLaw& law)
{
    const auto [k1, F1, F2, fall_mm, k3] = law.numbers;
    const double top_mm = F1 / k1, fall = (F2 - F1) / fall_mm;
    return {{0.0, 0.0, k1, k1}, {top_mm, F1, k1, fall}, {top_mm + fall_mm, F2, fall, k3}};
}

/// Returns the slope at the end of a curve from the parabola through the last three points, limited so that the curve
/// stays within the measured range.
/// @param s0,h0  slope and length of the last segment
/// @param s1,h1  slope and length of the segment before
double endSlope(double s0, double h0, double s1, double h1)
{
    const double slope = s0 + (s0 - s1) * h0 / (h0 + h1);
    if (slope * s0 <= 0.0) {
        return 0.0;
    }
    return s0 * s1 <= 0.0 && std::abs(slope) > 3.0 * std::abs(s0) ? 3.0 * s0 : slope;
}

/// Interpolates measured points without overshoot and without rising where the points fall.
/// @par Source Fritsch & Butland, SIAM J. Sci. Stat. Comput. 5 (1984), doi:10.1137/0905021: the slope at a point is the
/// weighted harmonic mean of the slopes of its two segments; 0 where only one of them rises.
std::vector<Knot> points(const ForceLaw& law)
{
    std::vector<Knot> knots;
    for (const ForceLaw::Point& point : law.points) {
        knots.push_back({point[0], point[1], 0.0, 0.0});
    }
    const std::size_t last = knots.size() - 1;
    const auto length = [&](std::size_t i) { return knots[i + 1].depth_mm - knots[i].depth_mm; };
    const auto line = [&](std::size_t i) { return (knots[i + 1].force_N - knots[i].force_N) / length(i); };
    for (std::size_t i = 0; i <= last; ++i) {
        double slope = 0.0;
        if (last == 1) {
            slope = line(0);
        } else if (i == 0) {
            slope = endSlope(line(0), length(0), line(1), length(1));
        } else if (i == last) {
            slope = endSlope(line(last - 1), length(last - 1), line(last - 2), length(last - 2));
        } else if (const double before = line(i - 1), after = line(i); before * after > 0.0) {
            const double w1 = 2.0 * length(i) + length(i - 1), w2 = length(i) + 2.0 * length(i - 1);
            slope = (w1 + w2) / (w1 / before + w2 / after);
        }
        knots[i].slopeBefore = knots[i].slopeAfter = slope;
    }
    // Beyond the measured range the force never decreases.
    knots[last].slopeAfter = std::max(0.0, knots[last].slopeAfter);
    return knots;
}

} // namespace

std::vector<ForceTable::Knot> knotsOf(const core::ForceLaw& law)
{
    switch (law.kind) {
    case core::LawKind::Exponential:
        return exponential(law);
    case core::LawKind::Hertz:
        return hertz(law);
    case core::LawKind::Layer:
        return layer(law);
    case core::LawKind::Click:
        return click(law);
    case core::LawKind::Points:
        return points(law);
    case core::LawKind::Linear:
        break;
    }
    return {};
}

} // namespace palpate::haptics::law
