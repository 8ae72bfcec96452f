// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/ForceTable.h"

#include <palpate/core/ForceLaw.h>

#include <vector>

namespace palpate::haptics::law {

/// Computes the knots of a nonlinear law, with the exact force and slope at each knot, so that the error of a
/// ForceTable between them is at most 1e-7 of the force at kReach_mm.
/// @pre core::check(law) succeeds
[[nodiscard]] std::vector<ForceTable::Knot> knotsOf(const core::ForceLaw& law);

} // namespace palpate::haptics::law
