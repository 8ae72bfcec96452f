// SPDX-License-Identifier: BSD-3-Clause
#include "nearby/TriangleBatch.h"

#include <algorithm>
#include <cstring>

namespace palpate::haptics::internal {

float TriangleBatch::derive(const double* origin, TriangleGroup& group) noexcept
{
    for (int i = m_count; i < kLanes; ++i) {
        for (auto& corner : m_at) {
            corner[i] = corner[m_count - 1];
        }
        m_isTwoSided[i] = 0;
    }
    Corners corners;
    setCorners(m_at[0], m_at[1], m_at[2], origin, corners);
    std::memcpy(corners.isTwoSided, m_isTwoSided, sizeof corners.isTwoSided);
    return internal::derive(corners, group);
}

void TriangleBatch::project(const core::Vec3& from, const core::Vec3& u, double& low_mm, double& high_mm) const noexcept
{
    low_mm = high_mm = u.dot(core::Vec3::Map(m_at[0][0]));
    for (const auto& corner : m_at) {
        for (int i = 0; i < m_count; ++i) {
            const double along = u.dot(core::Vec3::Map(corner[i]));
            low_mm = std::min(low_mm, along);
            high_mm = std::max(high_mm, along);
        }
    }
    low_mm -= u.dot(from);
    high_mm -= u.dot(from);
}

} // namespace palpate::haptics::internal
