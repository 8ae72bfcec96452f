// SPDX-License-Identifier: BSD-3-Clause
#include "nearby/PlaneLanes.h"

#include "nearby/Float8.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate::haptics::internal {

namespace {

// Rounding error of a plane distance in single precision: twice a few ulp of the largest operands, times the squared
// longest edge over the double area. The area cancels, because the normal has the same length. The skin is far smaller
// than this error, so contacts are always tested again in double precision.
constexpr float kRounding = 2e-6f;

// The exact tests let a move pass outside an edge by up to 16 ulp of the product of the distances to its ends, divided
// by its length. Where this matters, the quotient is at most this factor times the cubed coordinates over the squared
// edge.
constexpr float kPassing = 8e-15f;

// Outside this range, a product of two squared edges loses precision.
constexpr float kLeast = 1e-15f;
constexpr float kLargest = 1e15f;

PALPATE_ALWAYS_INLINE std::uint64_t bitsOf(int count) noexcept
{
    return count >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
}

typedef double Double4 __attribute__((vector_size(32)));

PALPATE_ALWAYS_INLINE Double4 load4(const double* p) noexcept
{
    Double4 v;
    std::memcpy(&v, p, sizeof v);
    return v;
}

/// Transposes eight points, one per row, to three rows of eight.
PALPATE_ALWAYS_INLINE void storeByAxis(const core::Float4* row, float (*axis)[kLanes]) noexcept
{
    for (int half = 0; half < 2; ++half, row += 4) {
        const core::Float4 xy01 = __builtin_shufflevector(row[0], row[1], 0, 4, 1, 5);
        const core::Float4 xy23 = __builtin_shufflevector(row[2], row[3], 0, 4, 1, 5);
        const core::Float4 z01 = __builtin_shufflevector(row[0], row[1], 2, 6, 3, 7);
        const core::Float4 z23 = __builtin_shufflevector(row[2], row[3], 2, 6, 3, 7);
        const core::Float4 x = __builtin_shufflevector(xy01, xy23, 0, 1, 4, 5);
        const core::Float4 y = __builtin_shufflevector(xy01, xy23, 2, 3, 6, 7);
        const core::Float4 z = __builtin_shufflevector(z01, z23, 0, 1, 4, 5);
        std::memcpy(&axis[0][4 * half], &x, sizeof x);
        std::memcpy(&axis[1][4 * half], &y, sizeof y);
        std::memcpy(&axis[2][4 * half], &z, sizeof z);
    }
}

} // namespace

PALPATE_WIDE_LANES void setCorners(const double* const* a, const double* const* b, const double* const* c,
                                   const double* origin, Corners& corners) noexcept
{
    core::Float4 oa[kLanes], ab[kLanes], ac[kLanes];
    const Double4 from = load4(origin);
    for (int i = 0; i < kLanes; ++i) {
        const Double4 first = load4(a[i]);
        oa[i] = __builtin_convertvector(first - from, core::Float4);
        ab[i] = __builtin_convertvector(load4(b[i]) - first, core::Float4);
        ac[i] = __builtin_convertvector(load4(c[i]) - first, core::Float4);
    }
    storeByAxis(oa, corners.a);
    storeByAxis(ab, corners.ab);
    storeByAxis(ac, corners.ac);
}

PALPATE_WIDE_LANES float derive(const Corners& corners, FacetGroup& group) noexcept
{
    Float8 a[3], ab[3], ac[3], n[3];
    for (int axis = 0; axis < 3; ++axis) {
        a[axis] = load8(corners.a[axis]);
        ab[axis] = load8(corners.ab[axis]);
        ac[axis] = load8(corners.ac[axis]);
    }
    const Float8 zero{};
    Float8 reach = zero, ab2 = zero, ac2 = zero, bc2 = zero;
    for (int axis = 0; axis < 3; ++axis) {
        const int j = (axis + 1) % 3, k = (axis + 2) % 3;
        n[axis] = ab[j] * ac[k] - ab[k] * ac[j];
        ab2 += ab[axis] * ab[axis];
        ac2 += ac[axis] * ac[axis];
        const Float8 bc = ac[axis] - ab[axis];
        bc2 += bc * bc;
        const Float8 low = a[axis] + least(least(ab[axis], ac[axis]), zero);
        const Float8 high = a[axis] + greatest(greatest(ab[axis], ac[axis]), zero);
        // Twice the rounding of the conversions and of the sum.
        const Float8 outwards = (absolute(low) + absolute(high) + absolute(a[axis])) * 4e-7f + kLeast;
        store8(group.low[axis], low - outwards);
        store8(group.high[axis], high + outwards);
        reach = greatest(reach, greatest(absolute(low), absolute(high)));
    }
    const Float8 longest2 = greatest(greatest(ab2, ac2), bc2);
    store8(group.perShortest2, 1.0f / greatest(least(least(ab2, ac2), bc2), zero + kLeast));
    const Mask8 isSound = (longest2 > kLeast) & (longest2 < kLargest);
    Float8 offset = zero;
    for (int axis = 0; axis < 3; ++axis) {
        const Float8 sound = isSound ? n[axis] : zero;
        store8(group.normal[axis], sound);
        offset += sound * a[axis];
    }
    store8(group.offset, offset);
    store8(group.longest2, isSound ? longest2 : zero + kLargest);
    std::memcpy(group.isTwoSided, corners.isTwoSided, sizeof group.isTwoSided);
    float most = 0.0f;
    for (int i = 0; i < kLanes; ++i) {
        most = std::max(most, reach[i]);
    }
    return most;
}

PALPATE_WIDE_LANES std::uint64_t crossedLanes(const FacetGroup* groups, int count, const float* x, const float* y,
                                              float coordinates_mm, float around_mm) noexcept
{
    const float rounding = kRounding * coordinates_mm + around_mm;
    const float passing = kPassing * coordinates_mm * coordinates_mm * coordinates_mm;
    std::uint64_t all = 0;
    for (int first = 0; first < count; first += kLanes) {
        const FacetGroup& group = groups[first / kLanes];
        Float8 start = -load8(group.offset), end = start;
        for (int axis = 0; axis < 3; ++axis) {
            const Float8 n = load8(group.normal[axis]);
            start += n * x[axis];
            end += n * y[axis];
        }
        const Float8 slack = rounding * load8(group.longest2);
        Mask8 twoSided;
        std::memcpy(&twoSided, group.isTwoSided, sizeof twoSided);
        // From front to back; for a two-sided facet, from either side to the other.
        const std::uint32_t crosses =
            laneBits(((start >= -slack) & (end <= slack)) | (twoSided & (start <= slack) & (end >= -slack)));
        if (crosses == 0) {
            continue;
        }
        // Tests the intersection with the plane against the triangle's box. For a move within the plane, the fraction
        // is arbitrary or NaN, and the facet is kept.
        const Float8 depth = start - end;
        const Float8 share = start / depth;
        const Mask8 isCertain = absolute(depth) > 8.0f * slack;
        const Float8 beside = rounding + passing * load8(group.perShortest2);
        const Float8 shareSlack = 2.0f * slack / absolute(depth); // uncertainty of the fraction, from both distances
        Mask8 misses{};
        for (int axis = 0; axis < 3; ++axis) {
            const float d = y[axis] - x[axis];
            const Float8 met = x[axis] + share * d;
            const Float8 around = beside + shareSlack * std::fabs(d);
            misses |= (met < load8(group.low[axis]) - around) | (met > load8(group.high[axis]) + around);
        }
        all |= static_cast<std::uint64_t>(crosses & ~laneBits(misses & isCertain)) << first;
    }
    return all & bitsOf(count);
}

PALPATE_WIDE_LANES std::uint64_t crossedLanes(const FacetGroup* groups, int count, const float (*path)[3], int points,
                                              float coordinates_mm, float around_mm) noexcept
{
    const float rounding = kRounding * coordinates_mm + around_mm;
    const float passing = kPassing * coordinates_mm * coordinates_mm * coordinates_mm;
    float low[3], high[3];
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = high[axis] = path[0][axis];
        for (int i = 1; i < points; ++i) {
            low[axis] = std::min(low[axis], path[i][axis]);
            high[axis] = std::max(high[axis], path[i][axis]);
        }
    }
    std::uint64_t all = 0;
    for (int first = 0; first < count; first += kLanes) {
        const FacetGroup& group = groups[first / kLanes];
        const Float8 beside = rounding + passing * load8(group.perShortest2);
        Mask8 misses{};
        for (int axis = 0; axis < 3; ++axis) {
            misses |= (low[axis] - beside > load8(group.high[axis])) | (high[axis] + beside < load8(group.low[axis]));
        }
        if (laneBits(misses) == 0xffu) {
            continue;
        }
        const Float8 slack = rounding * load8(group.longest2);
        const Float8 nx = load8(group.normal[0]), ny = load8(group.normal[1]), nz = load8(group.normal[2]);
        const Float8 offset = load8(group.offset);
        Float8 most = nx * path[0][0] + ny * path[0][1] + nz * path[0][2] - offset, fewest = most;
        for (int i = 1; i < points; ++i) {
            const Float8 distance = nx * path[i][0] + ny * path[i][1] + nz * path[i][2] - offset;
            most = greatest(most, distance);
            fewest = least(fewest, distance);
        }
        const std::uint32_t crosses = laneBits((most >= -slack) & (fewest <= slack) & ~misses);
        all |= static_cast<std::uint64_t>(crosses) << first;
    }
    return all & bitsOf(count);
}

PALPATE_WIDE_LANES std::uint64_t nearLanes(const FacetGroup* groups, int count, const float* g, float reach_mm,
                                           float coordinates_mm) noexcept
{
    const float reach = reach_mm + kRounding * coordinates_mm;
    std::uint64_t all = 0;
    for (int first = 0; first < count; first += kLanes) {
        const FacetGroup& group = groups[first / kLanes];
        Float8 distance = -load8(group.offset);
        Mask8 isOutside{};
        for (int axis = 0; axis < 3; ++axis) {
            distance += load8(group.normal[axis]) * g[axis];
            isOutside |= (load8(group.low[axis]) > (g[axis] + reach)) | (load8(group.high[axis]) < (g[axis] - reach));
        }
        const Mask8 isNear = ~isOutside & (absolute(distance) <= reach * load8(group.longest2));
        all |= static_cast<std::uint64_t>(laneBits(isNear)) << first;
    }
    return all & bitsOf(count);
}

PALPATE_WIDE_LANES float boxDistance(const FacetGroup* groups, int count, const float* g) noexcept
{
    // The last group is padded with the last facet, so that every lane is valid.
    Float8 nearest = Float8{} + std::numeric_limits<float>::infinity();
    for (int first = 0; first < count; first += kLanes) {
        const FacetGroup& group = groups[first / kLanes];
        Float8 distance = Float8{} - std::numeric_limits<float>::infinity();
        for (int axis = 0; axis < 3; ++axis) {
            distance =
                greatest(distance, greatest(load8(group.low[axis]) - g[axis], g[axis] - load8(group.high[axis])));
        }
        nearest = least(nearest, distance);
    }
    float result = nearest[0];
    for (int i = 1; i < kLanes; ++i) {
        result = std::min(result, nearest[i]);
    }
    return result;
}

} // namespace palpate::haptics::internal
