// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/Evaluation.h"

namespace palpate::evaluation {

/// Slides each solver over a sphere of 50 mm radius with 20 n² triangles, at 100 mm/s and 5 mm depth. The solvers run
/// interleaved, a few ticks at a time, so that other load on the machine affects all of them equally.
/// @param seconds,bruteForceSeconds  time limit per solver
[[nodiscard]] std::vector<SizePoint> costOnSphere(int n, double seconds, double bruteForceSeconds);

/// The same slide for the product, interleaved: plain, with friction, with a force law, with a stiffness map, with
/// buried lumps, and with friction, law and map together.
[[nodiscard]] std::vector<SizePoint> costOfTissue(int n, double seconds);

/// Median times of the other solvers divided by the product's, for each sphere.
[[nodiscard]] std::vector<Ratio> ratiosOf(const std::vector<SizePoint>& sizes);

} // namespace palpate::evaluation
