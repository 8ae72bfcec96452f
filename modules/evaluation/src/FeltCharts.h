// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/FeltComparison.h"

#include <string>
#include <vector>

namespace palpate::evaluation::felt {

/// 0.333: "1/3"; infinite: "rigid"; else the number.
[[nodiscard]] std::string ratioText(double ratio);

/// Stiffness against cover for spheres of one size and ratio: bounds as a band, estimate, elements.
[[nodiscard]] std::string coverChart(const Comparison& comparison, double sphereRadius, double ratio);
/// Error of the estimate against the excess by the elements, each case under both presses.
[[nodiscard]] std::string estimateChart(const Comparison& comparison);

/// What there is of each, ascending.
[[nodiscard]] std::vector<double> radiiOf(const Comparison& comparison);
[[nodiscard]] std::vector<double> ratiosOf(const Comparison& comparison);

} // namespace palpate::evaluation::felt
