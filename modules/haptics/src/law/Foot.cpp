// SPDX-License-Identifier: BSD-3-Clause
#include "law/Foot.h"

#include "solver/ConstrainedPoint.h"

#include <algorithm>
#include <array>
#include <span>

namespace palpate::haptics::law {

Vec3 Foot::freePart(const Vec3& v) const noexcept
{
    std::array<Vec3, 3> normals;
    const std::size_t count = std::min(normals.size(), m_touch.planes.size());
    for (std::size_t i = 0; i < count; ++i) {
        normals[i] = m_touch.planes[i].n_W;
    }
    const Vec3 free = internal::freePart(v, std::span<const Vec3>(normals).first(count));
    if (m_touch.fingertip_mm > 0.0 && m_nearest.isCurved) {
        // A ball that rolls over an edge touches it all the while: its foot moves along the edge alone.
        return m_nearest.along.dot(free) * m_nearest.along;
    }
    return free;
}

} // namespace palpate::haptics::law
