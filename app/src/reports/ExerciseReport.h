// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/study/ExerciseScore.h>

namespace palpate::app {

/// Prints the score of an exercise.
void printExercise(const study::ExerciseScore& score);

} // namespace palpate::app
