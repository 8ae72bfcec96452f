// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/Evaluation.h"

namespace palpate::evaluation {

/// Selects the recommended setting for each subject and states the cost of the alternatives.
[[nodiscard]] std::vector<Advice> adviceFor(const Evaluation& evaluation);

/// Sets `isParetoOptimal` on the trials without pop-through that no other such trial beats in both time and error.
/// Errors below the product's bound of 1e-6 mm count as zero.
void markParetoFront(std::vector<Trial>& trials, const std::string& subject);

/// Just noticeable difference of force, in percent of the force. @par Source Pang, Tan & Durlach, Perception &
/// Psychophysics 49 (1991): about 7 % over 2.5 to 10 N.
inline constexpr double kForceJnd_percent = 7.0;

} // namespace palpate::evaluation
