// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/Evaluation.h"

#include <vector>

namespace palpate::evaluation {

/// Measures what a tick costs on a sphere of 50 mm radius and 20 n² triangles, sliding 5 mm deep at 100 mm/s.
/// @param seconds,bruteForceSeconds  that a solver may take
[[nodiscard]] std::vector<SizePoint> costOnSphere(int n, double seconds, double bruteForceSeconds);

} // namespace palpate::evaluation
