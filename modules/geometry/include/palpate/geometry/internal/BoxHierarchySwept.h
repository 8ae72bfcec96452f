// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Definitions of BoxHierarchy::visitSwept and visitAround (swept ball traversal); see BoxHierarchyVisit.h.

#include "palpate/geometry/BoxHierarchy.h"
#include "palpate/geometry/internal/BoxHierarchyVisit.h"

#include <palpate/core/Float4.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate::geometry {

namespace internal {

/// Rounding error bound of the float arithmetic on boxes: 17 ulp of the largest operand, for sums of up to about ten
/// terms. Factors near 1 in this file (1.000001; 0.99999 for squares and quotients) serve the same purpose for products
/// and roots, with half an ulp (6e-8) each.
inline constexpr float kBoxRounding = 2e-6f;

/// Ball swept along a segment, in floats relative to a hierarchy's origin, for culling boxes.
class SweptBall
{
  public:
    /// @param at    start of the segment [mm]
    /// @param along  vector to the end of the segment [mm]
    SweptBall(const Vec3& at, const Vec3& along, double reach_mm) noexcept
        : m_at(at)
        , m_along(along)
        , m_reach_mm(reach_mm)
    {
        m_largest = static_cast<float>((at.cwiseAbs() + along.cwiseAbs()).maxCoeff());
        clip(1.0);
    }

    /// Restricts the segment to its first `share` (0 to 1).
    void clip(double share) noexcept
    {
        double half2 = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            const double h = 0.5 * share * m_along[axis];
            m_mid[axis] = core::splat4(static_cast<float>(m_at[axis] + h));
            m_half[axis] = core::splat4(static_cast<float>(h));
            half2 += h * h;
        }
        m_perHalf2 = core::splat4(half2 > 1e-30 ? static_cast<float>(1.0 / half2) : 0.0f);
        // The direction to a box also has a rounding error, which is multiplied by half the segment's length.
        const double rounding = kBoxRounding * m_largest * (1.0 + 2.0 * std::sqrt(half2) / m_reach_mm);
        const auto reach = static_cast<float>(1.000001 * (m_reach_mm + rounding));
        m_reach2 = core::splat4(reach * reach);
    }

    /// @param c,e  centres and half extents of four boxes [mm]
    /// @return mask of the boxes that the ball may touch
    [[nodiscard]] core::Mask4 touches(const core::Float4* c, const core::Float4* e) const noexcept
    {
        using core::Float4;
        const Float4 zero{}, one = core::splat4(1.0f);
        Float4 from[3], along{};
        for (int axis = 0; axis < 3; ++axis) {
            from[axis] = c[axis] - m_mid[axis];
            along += from[axis] * m_half[axis];
        }
        // Parameter of the segment point nearest to the box's centre, and the parameter range of the nearest points to
        // anywhere in the box. The distance to the box is convex along the segment, so its tangent there is a lower
        // bound.
        const Float4 place = along * m_perHalf2;
        Float4 width{};
        for (int axis = 0; axis < 3; ++axis) {
            width += e[axis] * core::absolute(m_half[axis]);
        }
        width = width * m_perHalf2 * core::splat4(1.00001f) + core::splat4(1e-5f);
        const auto clamped = [&](Float4 v) { return core::least(core::greatest(v, -one), one); };
        const Float4 at = clamped(place), low = clamped(place - width), high = clamped(place + width);
        Float4 distance2{}, slope{};
        for (int axis = 0; axis < 3; ++axis) {
            const Float4 v = from[axis] - at * m_half[axis];
            const Float4 gap = core::greatest(core::absolute(v) - e[axis], zero);
            distance2 += gap * gap;
            slope += (v > zero ? gap : -gap) * m_half[axis];
        }
        const Float4 least = distance2 - core::greatest(slope * (high - at), -slope * (at - low));
        return ~((least > zero) & (least * least > m_reach2 * distance2));
    }

    /// As `touches`, for a segment of zero length.
    [[nodiscard]] core::Mask4 touchesAtStart(const core::Float4* c, const core::Float4* e) const noexcept
    {
        core::Float4 distance2{};
        for (int axis = 0; axis < 3; ++axis) {
            const core::Float4 gap = core::greatest(core::absolute(c[axis] - m_mid[axis]) - e[axis], core::Float4{});
            distance2 += gap * gap;
        }
        return distance2 <= m_reach2;
    }

    /// @return mask of the boxes that are not entirely behind the plane through the start, perpendicular to the segment
    [[nodiscard]] core::Mask4 isAhead(const core::Float4* c, const core::Float4* e) const noexcept
    {
        core::Float4 most{}, size{};
        for (int axis = 0; axis < 3; ++axis) {
            const auto along = static_cast<float>(m_along[axis]);
            most += (c[axis] - core::splat4(static_cast<float>(m_at[axis]))) * core::splat4(along) +
                    e[axis] * core::splat4(std::fabs(along));
            size += core::splat4(std::fabs(along));
        }
        return most >= size * core::splat4(-kBoxRounding * m_largest);
    }

    /// @param u  unit vector along the segment
    /// @return mask of the boxes with a point whose direction from the start may have at least this cosine to u
    [[nodiscard]] core::Mask4 mayBeWithinCone(const core::Float4* c, const core::Float4* e, const Vec3& u,
                                              double cosine) const noexcept
    {
        core::Float4 most{}, size{}, distance2{};
        for (int axis = 0; axis < 3; ++axis) {
            const core::Float4 v = c[axis] - core::splat4(static_cast<float>(m_at[axis]));
            const core::Float4 gap = core::greatest(core::absolute(v) - e[axis], core::Float4{});
            most += v * core::splat4(static_cast<float>(u[axis])) +
                    e[axis] * core::splat4(static_cast<float>(std::abs(u[axis])));
            size += core::absolute(v) + e[axis];
            distance2 += gap * gap;
        }
        // Adds the rounding error of this sum and of the distance.
        most += core::splat4(kBoxRounding) * (size + core::splat4(2.0f * m_largest));
        const auto least2 = static_cast<float>(0.99999 * cosine * cosine);
        return ~((most < core::Float4{}) | (most * most < core::splat4(least2) * distance2));
    }

    /// @return lower bound of the distance from the start to the nearest used box [mm]
    [[nodiscard]] double distanceFromStart(const core::Float4* c, const core::Float4* e,
                                           core::Mask4 isUsed) const noexcept
    {
        core::Float4 distance2{};
        for (int axis = 0; axis < 3; ++axis) {
            const core::Float4 v = c[axis] - core::splat4(static_cast<float>(m_at[axis]));
            const core::Float4 gap = core::greatest(core::absolute(v) - e[axis], core::Float4{});
            distance2 += gap * gap;
        }
        double least2 = std::numeric_limits<double>::infinity();
        for (std::uint32_t lanes = core::laneBits(isUsed); lanes != 0; lanes &= lanes - 1) {
            least2 = std::min(least2, static_cast<double>(distance2[std::countr_zero(lanes)]));
        }
        return 0.999999 * std::sqrt(least2) - 2.0 * kBoxRounding * m_largest;
    }

    /// @return sort key of the boxes, ascending from near to far
    [[nodiscard]] core::Float4 order(const core::Float4* c) const noexcept
    {
        core::Float4 along{};
        for (int axis = 0; axis < 3; ++axis) {
            along += c[axis] * core::splat4(static_cast<float>(m_along[axis]));
        }
        return along;
    }

  private:
    Vec3 m_at, m_along;
    double m_reach_mm;
    float m_largest = 0.0f;
    core::Float4 m_mid[3]{}, m_half[3]{}, m_perHalf2{}, m_reach2{};
};

/// Computes centres and half extents of a node's child boxes, rounded outwards.
/// @return mask of the used children
inline core::Mask4 boxesOf(const BoxHierarchy::Node& node, core::Float4* c, core::Float4* e) noexcept
{
    using core::load4, core::splat4;
    core::Mask4 isUsed = load4(node.low[0]) <= load4(node.high[0]);
    for (int axis = 0; axis < 3; ++axis) {
        const core::Float4 low = load4(node.low[axis]), high = load4(node.high[axis]);
        c[axis] = (low + high) * splat4(0.5f);
        e[axis] = (high - low) * splat4(0.5f) + (core::absolute(low) + core::absolute(high)) * splat4(4e-7f);
    }
    return isUsed;
}

/// Clips a segment to the parameter range `first` to `last` that is within `reach_mm` of the union of a node's boxes.
/// @return false if the range is empty
inline bool clipToBoxes(const BoxHierarchy::Node& node, const Vec3& start, const Vec3& whole, double reach_mm,
                        double& first, double& last) noexcept
{
    for (int axis = 0; axis < 3; ++axis) {
        double low = 0.0, high = 0.0;
        bool isAny = false;
        for (int lane = 0; lane < 4; ++lane) {
            if (node.low[axis][lane] <= node.high[axis][lane]) {
                low = isAny ? std::min<double>(low, node.low[axis][lane]) : node.low[axis][lane];
                high = isAny ? std::max<double>(high, node.high[axis][lane]) : node.high[axis][lane];
                isAny = true;
            }
        }
        const double around = 1.01 * reach_mm + 1e-6 * (high - low);
        if (whole[axis] == 0.0) {
            if (start[axis] < low - around || start[axis] > high + around) {
                return false;
            }
            continue;
        }
        const double a = (low - around - start[axis]) / whole[axis], b = (high + around - start[axis]) / whole[axis];
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    return first <= last;
}

} // namespace internal

template<class Leaf>
std::uint32_t BoxHierarchy::visitAround(const Vec3& p, double reach_mm, Leaf&& leaf) const noexcept
{
    if (m_nodes.empty()) {
        return 0;
    }
    const internal::SweptBall ball(p - m_origin, Vec3::Zero(), reach_mm);
    // Batched traversal: nodes are prefetched when found and tested together, so that their cache misses overlap.
    std::uint32_t stack[kWave * kStack];
    std::uint32_t wave[kWave];
    std::uint32_t visited = 0;
    int top = 0, found = 1;
    wave[0] = 0;
    while (found > 0) {
        for (int i = 0; i < found; ++i) {
            const Node& node = m_nodes[wave[i]];
            core::Float4 c[3], e[3];
            const core::Mask4 isUsed = internal::boxesOf(node, c, e);
            ++visited;
            std::uint32_t lanes = core::laneBits(isUsed & ball.touchesAtStart(c, e));
            for (std::uint32_t leaves = lanes & node.leafMask; leaves != 0; leaves &= leaves - 1) {
                const std::uint32_t child = node.child[std::countr_zero(leaves)];
                if (!leaf(child >> 3, child & 7u)) {
                    return visited;
                }
            }
            for (lanes &= ~node.leafMask; lanes != 0; lanes &= lanes - 1) {
                const std::uint32_t child = node.child[std::countr_zero(lanes)];
                core::prefetch(&m_nodes[child]);
                core::prefetch(m_nodes[child].child);
                stack[top++] = child;
            }
        }
        for (found = 0; found < kWave && top > 0; ++found) {
            wave[found] = stack[--top];
        }
    }
    return visited;
}

template<class Leaf>
double BoxHierarchy::visitSwept(const Vec3& from, const Vec3& to, double reach_mm, SweptPruning interest,
                                std::uint32_t& nodes, Leaf&& leaf) const noexcept
{
    constexpr double kAll = std::numeric_limits<double>::infinity();
    if (m_nodes.empty()) {
        return kAll;
    }
    // Clip the segment to the root's box, enlarged by the reach: no contact is possible outside, and all floats then
    // have the magnitude of the model.
    double first = 0.0, last = interest.share;
    if (!internal::clipToBoxes(m_nodes[0], from - m_origin, to - from, reach_mm, first, last)) {
        return kAll;
    }
    const Vec3 along = (last - first) * (to - from);
    const Vec3 u = (to - from).normalized();
    internal::SweptBall ball(from + first * (to - from) - m_origin, along, reach_mm);
    std::uint32_t stack[kStack];
    int top = 0;
    std::uint32_t current = 0;
    // Lower bound of the free distance before contact with the current node and the nodes on the stack.
    const auto remainingFreeDistance = [&] {
        double least = kAll;
        for (;; current = stack[--top]) {
            core::Float4 c[3], e[3];
            const core::Mask4 isUsed = internal::boxesOf(m_nodes[current], c, e);
            least = std::min(least, ball.distanceFromStart(c, e, isUsed));
            if (top == 0) {
                return std::max(0.0, first * (to - from).norm() + least - reach_mm);
            }
        }
    };
    for (;;) {
        if (nodes == 0) {
            return remainingFreeDistance();
        }
        --nodes;
        const Node& node = m_nodes[current];
        core::Float4 c[3], e[3];
        const core::Mask4 isUsed = internal::boxesOf(node, c, e);
        std::uint32_t lanes = core::laneBits(isUsed & ball.isAhead(c, e) & ball.touches(c, e));
        if (interest.cosine > 0.0) {
            lanes &= core::laneBits(ball.mayBeWithinCone(c, e, u, interest.cosine));
        }
        for (std::uint32_t leaves = lanes & node.leafMask; leaves != 0; leaves &= leaves - 1) {
            const std::uint32_t child = node.child[std::countr_zero(leaves)];
            const double share = interest.share;
            interest = leaf(child >> 3, child & 7u);
            if (interest.share < share) {
                if (interest.share < 0.0) {
                    return remainingFreeDistance();
                }
                if (interest.share < first) {
                    return kAll;
                }
                ball.clip(last > first ? (interest.share - first) / (last - first) : 1.0);
            }
        }
        lanes &= ~node.leafMask;
        if (lanes != 0) {
            const int begin = top;
            top = internal::pushFarthestFirst(node, lanes, ball.order(c), stack, top);
            for (int i = begin; i < top; ++i) {
                core::prefetch(&m_nodes[stack[i]]);
                core::prefetch(m_nodes[stack[i]].child);
            }
        }
        if (top == 0) {
            return kAll;
        }
        current = stack[--top];
    }
}

} // namespace palpate::geometry
