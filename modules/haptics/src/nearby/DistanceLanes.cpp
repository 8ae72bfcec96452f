// SPDX-License-Identifier: BSD-3-Clause
#include "nearby/DistanceLanes.h"

#include <palpate/core/Float8.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace palpate::haptics::internal {

namespace {

using core::absolute;
using core::Float8;
using core::greatest;
using core::least;
using core::load8;
using core::Mask8;
using core::store8;

constexpr float kSmallest = 1e-30f;

// Longest edge squared over twice the area, squared: flatter triangles than 1e3 are not told apart from their normal.
constexpr float kFlattest2 = 1e6f;

} // namespace

PALPATE_WIDE_LANES float derive(const Corners& corners, TriangleGroup& group) noexcept
{
    group.corners = corners;
    Float8 ab[3], ac[3], bc[3];
    Float8 reach{}, ab2{}, ac2{}, bc2{}, n2{};
    for (int axis = 0; axis < 3; ++axis) {
        const Float8 a = load8(corners.a[axis]);
        ab[axis] = load8(corners.ab[axis]);
        ac[axis] = load8(corners.ac[axis]);
        bc[axis] = ac[axis] - ab[axis];
        ab2 += ab[axis] * ab[axis];
        ac2 += ac[axis] * ac[axis];
        bc2 += bc[axis] * bc[axis];
        reach = greatest(reach, absolute(a) + greatest(absolute(ab[axis]), absolute(ac[axis])));
    }
    Float8 n[3];
    for (int axis = 0; axis < 3; ++axis) {
        const int j = (axis + 1) % 3, k = (axis + 2) % 3;
        n[axis] = ab[j] * ac[k] - ab[k] * ac[j];
        n2 += n[axis] * n[axis];
    }
    const Float8 longest2 = greatest(greatest(ab2, ac2), bc2);
    const Mask8 isSound = (n2 > kSmallest) & (longest2 * longest2 < n2 * kFlattest2);
    const Float8 zero{};
    for (int axis = 0; axis < 3; ++axis) {
        store8(group.normal[axis], isSound ? n[axis] : zero);
    }
    const Float8 one = zero + 1.0f;
    store8(group.perNormal2, isSound ? one / n2 : zero);
    store8(group.perEdge2[0], one / greatest(ab2, zero + kSmallest));
    store8(group.perEdge2[1], one / greatest(ac2, zero + kSmallest));
    store8(group.perEdge2[2], one / greatest(bc2, zero + kSmallest));
    float most = 0.0f;
    for (int i = 0; i < kLanes; ++i) {
        most = std::max(most, reach[i]);
    }
    return most;
}

PALPATE_WIDE_LANES void distances(const TriangleGroup* groups, int count, const float* p, const float* half,
                                  float* distance_mm) noexcept
{
    alignas(32) float along[kMostTriangles]; // how much the half moves lead away, times the distance
    for (int first = 0; first < count; first += kLanes) {
        const TriangleGroup& group = groups[first / kLanes];
        const Float8 zero{};
        const Float8 one = zero + 1.0f;
        Float8 ap[3], ab[3], ac[3], n[3];
        Float8 height{}, apab{}, apac{}, bpbc{};
        for (int axis = 0; axis < 3; ++axis) {
            ap[axis] = p[axis] - load8(group.corners.a[axis]);
            ab[axis] = load8(group.corners.ab[axis]);
            ac[axis] = load8(group.corners.ac[axis]);
            n[axis] = load8(group.normal[axis]);
            height += n[axis] * ap[axis];
            apab += ap[axis] * ab[axis];
            apac += ap[axis] * ac[axis];
            bpbc += (ap[axis] - ab[axis]) * (ac[axis] - ab[axis]);
        }
        // Inside when the point lies to the left of all three edges.
        Float8 leftAb{}, leftAc{}, leftBc{};
        for (int axis = 0; axis < 3; ++axis) {
            const int j = (axis + 1) % 3, k = (axis + 2) % 3;
            leftAb += n[axis] * (ab[j] * ap[k] - ab[k] * ap[j]);
            leftAc += n[axis] * (ap[j] * ac[k] - ap[k] * ac[j]);
            leftBc += n[axis] * ((ac[j] - ab[j]) * (ap[k] - ab[k]) - (ac[k] - ab[k]) * (ap[j] - ab[j]));
        }
        const Mask8 isInside = (leftAb >= 0.0f) & (leftAc >= 0.0f) & (leftBc >= 0.0f);
        const Float8 tab = least(greatest(apab * load8(group.perEdge2[0]), zero), one);
        const Float8 tac = least(greatest(apac * load8(group.perEdge2[1]), zero), one);
        const Float8 tbc = least(greatest(bpbc * load8(group.perEdge2[2]), zero), one);
        Float8 ab2{}, ac2{}, bc2{}, onN{}, onAb{}, onAc{}, onBc{};
        for (int axis = 0; axis < 3; ++axis) {
            const Float8 toAb = ap[axis] - tab * ab[axis];
            const Float8 toAc = ap[axis] - tac * ac[axis];
            const Float8 toBc = ap[axis] - ab[axis] - tbc * (ac[axis] - ab[axis]);
            ab2 += toAb * toAb;
            ac2 += toAc * toAc;
            bc2 += toBc * toBc;
            onN += n[axis] * half[axis];
            onAb += toAb * half[axis];
            onAc += toAc * half[axis];
            onBc += toBc * half[axis];
        }
        const Float8 perNormal2 = load8(group.perNormal2);
        const Float8 outside2 = least(least(ab2, ac2), bc2);
        const Float8 onOutside = ab2 == outside2 ? onAb : ac2 == outside2 ? onAc : onBc;
        const Float8 d2 = isInside ? height * height * perNormal2 : outside2;
        const Float8 on = isInside ? height * perNormal2 * onN : onOutside;
        // Squared until the end: the square roots are taken side by side.
        store8(distance_mm + first, perNormal2 > 0.0f ? d2 : zero);
        store8(along + first, absolute(on));
    }
    const int lanes = (count + kLanes - 1) / kLanes * kLanes;
    for (int i = 0; i < lanes; ++i) {
        const float distance = std::sqrt(distance_mm[i]);
        // A distance from a convex set along a line is convex: it lies above its tangent.
        distance_mm[i] = distance - along[i] / std::max(distance, kSmallest);
    }
}

void copyTriangle(const TriangleGroup* from, int i, TriangleGroup* to, int j) noexcept
{
    static_assert(std::is_trivially_copyable_v<TriangleGroup> && sizeof(float) == sizeof(std::int32_t));
    constexpr std::size_t kRow = sizeof(float) * kLanes;
    const auto* source = reinterpret_cast<const std::byte*>(from + i / kLanes) + sizeof(float) * (i % kLanes);
    auto* target = reinterpret_cast<std::byte*>(to + j / kLanes) + sizeof(float) * (j % kLanes);
    for (std::size_t row = 0; row < sizeof(TriangleGroup); row += kRow) {
        std::memcpy(target + row, source + row, sizeof(float));
    }
}

PALPATE_WIDE_LANES std::uint64_t lanesBetween(const float* distance_mm, int count, float beyond, float upTo) noexcept
{
    std::uint64_t all = 0;
    for (int first = 0; first < count; first += kLanes) {
        const Float8 distance = load8(distance_mm + first);
        all |= static_cast<std::uint64_t>(core::laneBits((distance > beyond) & (distance <= upTo))) << first;
    }
    return count >= 64 ? all : all & ((std::uint64_t{1} << count) - 1);
}

} // namespace palpate::haptics::internal
