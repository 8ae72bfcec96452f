// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <algorithm>
#include <cmath>

namespace palpate::haptics::internal {

using core::Vec3;

/// Returns the fraction of the move x → y that stays inside the box.
/// @pre x is inside the box
[[nodiscard]] inline double insideFraction(const core::Box& box, const Vec3& x, const Vec3& y) noexcept
{
    double share = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double d = y[axis] - x[axis];
        const double room = d > 0.0 ? box.max()[axis] - x[axis] : x[axis] - box.min()[axis];
        if (std::abs(d) > room) {
            share = std::min(share, room / std::abs(d));
        }
    }
    return share;
}

} // namespace palpate::haptics::internal
