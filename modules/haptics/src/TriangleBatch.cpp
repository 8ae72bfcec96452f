// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/haptics/internal/TriangleBatch.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace palpate::haptics::internal {

float TriangleBatch::derive(const double* origin, TriangleGroup& group) noexcept
{
    for (int i = m_count; i < kLanes; ++i) {
        for (auto& corner : m_at) {
            corner[i] = corner[m_count - 1];
        }
    }
    Corners corners;
    setCorners(m_at[0], m_at[1], m_at[2], origin, corners);
    std::memset(corners.isTwoSided, 0, sizeof corners.isTwoSided);
    return internal::derive(corners, group);
}

core::Vec3 TriangleBatch::middle(double& spread_mm) const noexcept
{
    const core::Vec3 first = core::Vec3::Map(m_at[0][0]);
    double spread2 = 0.0;
    for (const auto& corner : m_at) {
        for (int i = 0; i < m_count; ++i) {
            spread2 = std::max(spread2, (core::Vec3::Map(corner[i]) - first).squaredNorm());
        }
    }
    spread_mm = std::sqrt(spread2);
    return first;
}

} // namespace palpate::haptics::internal
