// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/Spread.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate::evaluation {

namespace {

constexpr double kConfidence = 0.95;

/// Student's t quantile at 97.5 %.
double studentT(std::size_t degreesOfFreedom)
{
    constexpr std::array kTable{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228, 2.201, 2.179};
    if (degreesOfFreedom <= kTable.size()) {
        return kTable[degreesOfFreedom - 1];
    }
    // Expansion in 1/df around the normal quantile, Abramowitz & Stegun 26.7.5; error at most 3e-3 here.
    const auto df = static_cast<double>(degreesOfFreedom);
    return 1.960 + 2.372 / df + 2.823 / (df * df);
}

/// Probability that the median is between the values of rank k and n + 1 - k, both counted from 1.
double medianCoverage(std::size_t n, std::size_t k)
{
    double below = 0.0, term = std::pow(0.5, static_cast<double>(n));
    for (std::size_t i = 0; i < k; ++i) {
        below += term;
        term *= static_cast<double>(n - i) / static_cast<double>(i + 1);
    }
    return std::max(0.0, 1.0 - 2.0 * below);
}

} // namespace

Spread spreadOf(std::vector<double> values, double floor, double most)
{
    Spread result;
    result.values = values;
    if (values.empty()) {
        return result;
    }
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    result.median = 0.5 * (values[(n - 1) / 2] + values[n / 2]);
    std::size_t rank = 1;
    while (2 * (rank + 1) <= n && medianCoverage(n, rank + 1) >= kConfidence) {
        ++rank;
    }
    result.medianLow = values[rank - 1];
    result.medianHigh = values[n - rank];
    result.confidence = n > 1 ? medianCoverage(n, rank) : 0.0;
    result.low = values.front();
    result.high = values.back();
    if (n > 1) {
        double mean = 0.0, squares = 0.0;
        for (const double v : values) {
            mean += std::log(std::max(floor, v)) / static_cast<double>(n);
        }
        for (const double v : values) {
            const double d = std::log(std::max(floor, v)) - mean;
            squares += d * d;
        }
        const double reach = studentT(n - 1) * std::sqrt(squares / static_cast<double>(n - 1)) *
                             std::sqrt(1.0 + 1.0 / static_cast<double>(n));
        result.low = std::min(result.low, std::max(floor, std::exp(mean - reach)));
        result.high = std::max(result.high, std::min(most, std::exp(mean + reach)));
    }
    return result;
}

} // namespace palpate::evaluation
