// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/Evaluation.h"

#include <string>

namespace palpate::evaluation {

/// Colour of a solver in all charts of the report.
[[nodiscard]] std::string colourOf(const std::string& solver);

/// Time per tick against error, one mark per trial of the subject, with the Pareto front and reference lines.
[[nodiscard]] std::string speedAgainstErrorChart(const Evaluation& evaluation, const std::string& subject);
/// Figure 3 of the paper: force in the corner between two surfaces against the angle.
[[nodiscard]] std::string cornerChart(const Evaluation& evaluation);
/// Time per tick against the number of triangles.
[[nodiscard]] std::string costBySizeChart(const Evaluation& evaluation);
/// Error of each solver over the first motion on the subject.
[[nodiscard]] std::string errorOverTimeChart(const Evaluation& evaluation, const std::string& subject);
/// Histogram of the product's iterations per tick.
[[nodiscard]] std::string iterationsChart(const Evaluation& evaluation);

} // namespace palpate::evaluation
