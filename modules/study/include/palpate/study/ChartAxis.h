// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <string>
#include <string_view>
#include <vector>

namespace palpate::study {

/// Escapes text for HTML and SVG.
[[nodiscard]] PALPATE_EXPORT std::string escaped(std::string_view text);
/// Formats a number with at most three digits, with a power of ten in superscripts where shorter: 0.35, 12, 2·10⁻⁹.
[[nodiscard]] PALPATE_EXPORT std::string shortNumber(double value);

/// Axis range of a chart.
struct PALPATE_EXPORT ChartAxis
{
    double low = 0.0;
    double high = 1.0;
    bool isLog = false;
    std::string title;

    /// Logarithmic axis of whole decades that covers the positive `values`.
    [[nodiscard]] static ChartAxis decades(const std::vector<double>& values, std::string title);
    /// Linear axis from 0 to a round number above all `values`.
    [[nodiscard]] static ChartAxis linear(const std::vector<double>& values, std::string title);
    /// Relative position of `value` on the axis, clamped to 0 to 1.
    [[nodiscard]] double share(double value) const;
    [[nodiscard]] std::vector<double> ticks() const;
};

} // namespace palpate::study
