// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/Evaluation.h"

#include <string>

namespace palpate::evaluation {

/// Colour that a solver has throughout the report.
[[nodiscard]] std::string colourOf(const std::string& solver);

/// Time a tick against error, one mark for each trial of the subject, with the front and the reference lines.
[[nodiscard]] std::string speedAgainstErrorChart(const Evaluation& evaluation, const std::string& subject);
/// Figure 3 of the paper: force in the corner between two surfaces over their angle.
[[nodiscard]] std::string cornerChart(const Evaluation& evaluation);
/// What a tick costs by the number of triangles.
[[nodiscard]] std::string costBySizeChart(const Evaluation& evaluation);
/// Error of each solver over the first motion on the subject.
[[nodiscard]] std::string errorOverTimeChart(const Evaluation& evaluation, const std::string& subject);
/// How many ticks of the product took how many iterations.
[[nodiscard]] std::string iterationsChart(const Evaluation& evaluation);

} // namespace palpate::evaluation
