// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/Evaluation.h"

namespace palpate::evaluation {

/// Works out which setting to use on each subject, and what it and the others cost.
[[nodiscard]] std::vector<Advice> adviceFor(const Evaluation& evaluation);

/// Sets `isOnFront` on the trials that never pop through and that no other such is better than in both time and error,
/// errors below the product's bound of 1e-6 mm counting as none.
void markFront(std::vector<Trial>& trials, const std::string& subject);

/// Just noticeable difference of force, in percent of it. @par Source Pang, Tan & Durlach, Perception & Psychophysics
/// 49 (1991): about 7 % over 2.5 to 10 N.
inline constexpr double kForceJnd_percent = 7.0;

} // namespace palpate::evaluation
