// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/ForceTable.h"

#include <palpate/core/ForceLaw.h>

#include <vector>

namespace palpate::haptics::law {

/// The knots of a law that is not linear: its own force and slope at each, so that between them a ForceTable is at most
/// 1e-7 of the force at kReach_mm away from the formula.
/// @pre core::check(law) is fine
[[nodiscard]] std::vector<ForceTable::Knot> knotsOf(const core::ForceLaw& law);

} // namespace palpate::haptics::law
