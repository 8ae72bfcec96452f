// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace palpate::evaluation {

/// Escapes text for HTML and SVG.
[[nodiscard]] std::string escaped(std::string_view text);
/// A number in three digits at most, with powers of ten as superscripts where they are shorter: 0.35, 12, 2·10⁻⁹.
[[nodiscard]] std::string shortNumber(double value);

/// Range of one axis of a chart.
struct ChartAxis
{
    double low = 0.0;
    double high = 1.0;
    bool isLog = false;
    std::string title;

    /// A logarithmic axis of whole decades around what is positive in `values`.
    [[nodiscard]] static ChartAxis decades(const std::vector<double>& values, std::string title);
    /// A linear axis from 0 to a round number above all of `values`.
    [[nodiscard]] static ChartAxis linear(const std::vector<double>& values, std::string title);
    /// Share of the axis at `value`, 0 … 1, clamped.
    [[nodiscard]] double share(double value) const;
    [[nodiscard]] std::vector<double> ticks() const;
};

} // namespace palpate::evaluation
