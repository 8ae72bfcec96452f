// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/Evaluation.h"

namespace palpate::evaluation {

/// Describes the current machine and the build.
[[nodiscard]] Machine thisMachine();

} // namespace palpate::evaluation
