// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace palpate::evaluation {

/// Figure measured once per path: the median, a confidence interval of the median and a prediction interval for
/// another path.
struct Spread
{
    std::vector<double> values; ///< one per path, in the order of the paths
    double median = 0.0;
    /// Confidence interval of the median between two of the values: the narrowest one with at least 95 % confidence.
    /// Below six paths even the full range has less (three paths: 75 %).
    double medianLow = 0.0, medianHigh = 0.0, confidence = 0.0;
    /// 95 % prediction interval for one more path, assuming normally distributed logarithms; at least the range of the
    /// values. Equal to the median for a single path, whose spread is unknown.
    double low = 0.0, high = 0.0;
};

/// @param values  positive or zero; at least one
/// @param floor   smaller values are replaced by this for the logarithms; `low` is below `floor` only if a value is
/// @param most    upper limit of any path; limits `high`
/// @par Source Confidence interval of the median: order statistics of the binomial distribution (David & Nagaraja,
/// Order Statistics, section 7.1). Prediction interval: normal sample, mean ± t s sqrt(1 + 1/n).
[[nodiscard]] Spread spreadOf(std::vector<double> values, double floor,
                              double most = std::numeric_limits<double>::infinity());

} // namespace palpate::evaluation
