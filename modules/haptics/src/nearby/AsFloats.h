// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <algorithm>
#include <cmath>

namespace palpate::haptics::internal {

/// Converts a position relative to an origin to single precision.
/// @return the largest coordinate [mm]
inline float asFloats(const core::Vec3& p, const core::Vec3& origin, float* at) noexcept
{
    float most = 0.0f;
    for (int axis = 0; axis < 3; ++axis) {
        at[axis] = static_cast<float>(p[axis] - origin[axis]);
        most = std::max(most, std::abs(at[axis]));
    }
    return most;
}

} // namespace palpate::haptics::internal
