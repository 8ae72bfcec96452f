// SPDX-License-Identifier: BSD-3-Clause
#include "law/Foot.h"

#include "probe/ConstrainedPoint.h"

#include <algorithm>
#include <array>

namespace palpate::haptics::law {

Vec3 Foot::heldPart(Vec3 gradient, std::span<const ActiveConstraint> planes, bool isOnEdge, Vec3 along) noexcept
{
    std::array<Vec3, 3> normals;
    const std::size_t count = std::min(normals.size(), planes.size());
    for (std::size_t i = 0; i < count; ++i) {
        normals[i] = planes[i].n_W;
    }
    const Vec3 free = internal::freePart(gradient, std::span<const Vec3>(normals).first(count));
    // A ball that rolls over an edge stays in contact with this edge: its foot moves only along the edge.
    return isOnEdge ? Vec3(along.dot(free) * along) : free;
}

} // namespace palpate::haptics::law
