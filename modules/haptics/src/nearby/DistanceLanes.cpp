// SPDX-License-Identifier: BSD-3-Clause
#include "nearby/DistanceLanes.h"

#include "nearby/Float8.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <type_traits>

namespace palpate::haptics::internal {

namespace {

constexpr float kSmallest = 1e-30f;

// Maximum flatness, the squared longest edge over the double area, at which the normal of a triangle is used;
// kFlattest2 is its square. A product or difference in single precision has the relative error eps = 2^-24. The error
// of the normal along the triangle's longest direction is at most 6/sqrt(27) eps times two edges, which tilts the plane
// by 1.16 eps times the flatness. Over the triangle, which is at most sqrt(3) C long (C the largest coordinate), the
// tilt amounts to 2 eps C times the flatness, and to twice as much for a point beside the triangle. The remaining 8 eps
// C are the rounding of the coordinates.
constexpr float kFlattest = 75.0f;
constexpr float kFlattest2 = kFlattest * kFlattest;
constexpr double kFloatRounding = 0.5 * std::numeric_limits<float>::epsilon();
static_assert((2.0 * kFlattest + 8.0) * kFloatRounding <= kDistanceRounding);

// Two squared distances are considered equal if they differ by at most kAsNear d² + kAsNearAt C², C the largest
// coordinate: twice the geometric mean of the two terms is at least kSquareRounding d C.
constexpr float kAsNear = 1e-5f;
constexpr float kAsNearAt = 5e-7f;
static_assert(4.0 * kAsNear * kAsNearAt >= kSquareRounding * kSquareRounding);

/// Result for eight triangles, as seen from a point.
struct Away
{
    Float8 height;    ///< height above the plane, times the length of the normal [mm³]
    Float8 distance2; ///< squared distance; 0 for a triangle too flat to decide [mm²]
    Float8 along;     ///< component of v away from the closest point, times the distance [mm²]
};

/// Computes the closest points on eight triangles. Their positions are accurate to rounding, with one exception: if the
/// closest points on two edges are equally far away within rounding, these points, and so the directions away from
/// them, may differ by the square root of the rounding error.
/// @tparam isConservative  compute `along` as the minimum over all such points
/// @param coordinate_mm  largest coordinate of p and of the group
template<bool isConservative>
PALPATE_ALWAYS_INLINE Away awayFrom(const TriangleGroup& group, const float* p, const float* v,
                                    float coordinate_mm) noexcept
{
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
    // Inside if the point is to the left of all three edges.
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
        onN += n[axis] * v[axis];
        onAb += toAb * v[axis];
        onAc += toAc * v[axis];
        onBc += toBc * v[axis];
    }
    const Float8 perNormal2 = load8(group.perNormal2);
    const Float8 outside2 = least(least(ab2, ac2), bc2);
    Float8 onOutside;
    if constexpr (isConservative) {
        const Float8 asNear2 = outside2 * (1.0f + kAsNear) + kAsNearAt * coordinate_mm * coordinate_mm;
        const Float8 most = zero + std::numeric_limits<float>::infinity();
        onOutside =
            least(least(ab2 <= asNear2 ? onAb : most, ac2 <= asNear2 ? onAc : most), bc2 <= asNear2 ? onBc : most);
    } else {
        onOutside = ab2 == outside2 ? onAb : ac2 == outside2 ? onAc : onBc;
    }
    Away away;
    away.height = height;
    away.distance2 = perNormal2 > 0.0f ? (isInside ? height * height * perNormal2 : outside2) : zero;
    away.along = isInside ? height * perNormal2 * onN : onOutside;
    return away;
}

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
    alignas(32) float along[kMostTriangles]; // component of the half moves away from the triangle, times the distance
    for (int first = 0; first < count; first += kLanes) {
        const Away away = awayFrom<false>(groups[first / kLanes], p, half, 0.0f);
        // Squared up to here: the square roots are computed side by side.
        store8(distance_mm + first, away.distance2);
        store8(along + first, absolute(away.along));
    }
    const int lanes = (count + kLanes - 1) / kLanes * kLanes;
    for (int i = 0; i < lanes; ++i) {
        const float distance = std::sqrt(distance_mm[i]);
        // A distance from a convex set is convex along a line and lies above its tangent.
        distance_mm[i] = distance - along[i] / std::max(distance, kSmallest);
    }
}

PALPATE_WIDE_LANES Extent extentAlong(const TriangleGroup& group, const float* u) noexcept
{
    Float8 a{}, ab{}, ac{};
    for (int axis = 0; axis < 3; ++axis) {
        a += u[axis] * load8(group.corners.a[axis]);
        ab += u[axis] * load8(group.corners.ab[axis]);
        ac += u[axis] * load8(group.corners.ac[axis]);
    }
    const Float8 zero{};
    const Float8 low = a + least(least(ab, ac), zero), high = a + greatest(greatest(ab, ac), zero);
    Extent extent{low[0], high[0]};
    for (int i = 1; i < kLanes; ++i) {
        extent.low_mm = std::min(extent.low_mm, low[i]);
        extent.high_mm = std::max(extent.high_mm, high[i]);
    }
    return extent;
}

PALPATE_WIDE_LANES std::uint32_t opposingLanes(const TriangleGroup& group, const Heading& heading,
                                               float cosine) noexcept
{
    const Away away = awayFrom<true>(group, heading.x, heading.u, heading.coordinate_mm);
    const Float8 zero{};
    const Float8 rounding = zero + static_cast<float>(kDistanceRounding) * heading.coordinate_mm;
    Mask8 isTwoSided;
    std::memcpy(&isTwoSided, group.corners.isTwoSided, sizeof isTwoSided);
    const Float8 perNormal2 = load8(group.perNormal2);
    // Twice the rounding, because x may be beside the triangle.
    const Mask8 isBehind = (away.height < 0.0f) & (away.height * away.height * perNormal2 > 4.0f * rounding * rounding);
    // Twice the rounding, to include the error of the distance.
    const Float8 falls = 2.0f * rounding - away.along;
    const Mask8 isBeside = (falls < 0.0f) | (falls * falls < cosine * cosine * away.distance2);
    return laneBits((perNormal2 <= 0.0f) | ~(isBeside | (isBehind & ~isTwoSided)));
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
        all |= static_cast<std::uint64_t>(laneBits((distance > beyond) & (distance <= upTo))) << first;
    }
    return count >= 64 ? all : all & ((std::uint64_t{1} << count) - 1);
}

} // namespace palpate::haptics::internal
