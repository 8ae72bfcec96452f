// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/Evaluation.h"

namespace palpate::evaluation {

/// @return what this program runs on and was built with.
[[nodiscard]] Machine thisMachine();

} // namespace palpate::evaluation
