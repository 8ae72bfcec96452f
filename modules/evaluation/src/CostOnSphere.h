// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/Evaluation.h"

namespace palpate::evaluation {

/// Slides each solver over a sphere of 50 mm and 20 n² triangles at 100 mm/s, 5 mm deep, in turns of a few ticks, so
/// that what else the machine does falls on all of them.
/// @param seconds,bruteForceSeconds  that one solver may take
[[nodiscard]] std::vector<SizePoint> costOnSphere(int n, double seconds, double bruteForceSeconds);

/// The product on that slide, in turns too: plain, with friction, with a law, with a map of stiffness, and with all.
[[nodiscard]] std::vector<SizePoint> costOfTissue(int n, double seconds);

/// The medians of the other solvers over the product's, on each sphere.
[[nodiscard]] std::vector<Ratio> ratiosOf(const std::vector<SizePoint>& sizes);

} // namespace palpate::evaluation
