// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/FeltComparison.h"

#include <string>
#include <vector>

namespace palpate::evaluation::felt {

/// Formats a ratio: 0.333 as "1/3", infinity as "rigid", other values as numbers.
[[nodiscard]] std::string ratioText(double ratio);

/// Chart of stiffness against cover for spheres of one size and ratio: bounds as a band, estimate, finite elements.
[[nodiscard]] std::string coverChart(const Comparison& comparison, double sphereRadius, double ratio);
/// Chart of the estimate's error against the finite-element excess, with both presses for each case.
[[nodiscard]] std::string estimateChart(const Comparison& comparison);

/// Distinct values present in the comparison, ascending.
[[nodiscard]] std::vector<double> radiiOf(const Comparison& comparison);
[[nodiscard]] std::vector<double> ratiosOf(const Comparison& comparison);

} // namespace palpate::evaluation::felt
