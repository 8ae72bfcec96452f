// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace palpate::evaluation {

/// A figure measured once on each path of the hand: its median, how well the median is known, and where the figure of
/// another path can be expected.
struct Spread
{
    std::vector<double> values; ///< one for each path, in the order of the paths
    double median = 0.0;
    /// Interval of the median between two of the values, and the confidence that the median of all paths lies in it.
    /// The narrowest interval of at least 95 %; with fewer than six paths even least to greatest reaches less (three:
    /// 75 %).
    double medianLow = 0.0, medianHigh = 0.0, confidence = 0.0;
    /// Where one more path falls in 95 % of cases, if the logarithms are normally distributed; never narrower than from
    /// the least to the greatest value. Equal to the median with one path, of which no spread is known.
    double low = 0.0, high = 0.0;
};

/// @param values  positive, or zero; at least one
/// @param floor   smaller values count as this in the logarithms, and `low` is not less unless a value is
/// @param most    no path can exceed this; limits `high`
/// @par Source Interval of the median: order statistics of the binomial distribution (David & Nagaraja, Order
/// Statistics, section 7.1). Another path: prediction interval of a normal sample, mean ± t s sqrt(1 + 1/n).
[[nodiscard]] Spread spreadOf(std::vector<double> values, double floor,
                              double most = std::numeric_limits<double>::infinity());

} // namespace palpate::evaluation
