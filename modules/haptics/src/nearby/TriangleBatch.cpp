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

} // namespace palpate::haptics::internal
