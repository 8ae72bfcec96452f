// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Internal traversal templates of BoxHierarchy, defined in a header so that visitors are inlined.

#include "palpate/geometry/BoxHierarchy.h"

#include <palpate/core/Float4.h>

#include <algorithm>
#include <bit>
#include <utility>

namespace palpate::geometry {

namespace internal {

/// Pushes the children in `lanes` of a node, the last in `order` first, so that the first is popped next.
/// @return the new top of the stack
[[gnu::always_inline]] inline int pushFarthestFirst(const BoxHierarchy::Node& node, std::uint32_t lanes,
                                                    core::Float4 order, std::uint32_t* stack, int top) noexcept
{
    const int first = top;
    for (; lanes != 0; lanes &= lanes - 1) {
        int at = top++;
        stack[at] = static_cast<std::uint32_t>(std::countr_zero(lanes));
        for (; at > first && order[static_cast<int>(stack[at - 1])] < order[static_cast<int>(stack[at])]; --at) {
            std::swap(stack[at - 1], stack[at]);
        }
    }
    for (int i = first; i < top; ++i) {
        stack[i] = node.child[stack[i]];
    }
    return top;
}

/// Segment in floats relative to a hierarchy's origin, for culling boxes.
class Segment4
{
  public:
    /// @param start  start of the segment [mm]
    /// @param whole  vector to the end of the segment [mm]
    Segment4(const Vec3& start, const Vec3& whole, double around_mm) noexcept
        : m_start(start)
        , m_whole(whole)
        , m_around_mm(around_mm)
    {
        clip(1.0);
    }

    /// Restricts the segment to its first `share` (0 to 1).
    void clip(double share) noexcept
    {
        for (int axis = 0; axis < 3; ++axis) {
            const double h = 0.5 * share * m_whole[axis];
            const double m = m_start[axis] + h;
            m_mid[axis] = core::splat4(static_cast<float>(m));
            m_half[axis] = core::splat4(static_cast<float>(h));
            m_reach[axis] = core::splat4(std::fabs(static_cast<float>(h)));
        }
        // Rounding error of the float arithmetic below: a few ulp of the largest operand, so that boxes are kept in
        // doubt.
        m_slack = static_cast<float>(1.000001 * m_around_mm) +
                  8e-7f * static_cast<float>((m_start.cwiseAbs() + m_whole.cwiseAbs()).maxCoeff());
    }

    /// @param c  output: centres of the node's boxes relative to the middle of the segment [mm]
    /// @return bit i: the segment touches box i
    [[nodiscard]] std::uint32_t touched(const BoxHierarchy::Node& node, core::Float4* c) const noexcept
    {
        using core::absolute, core::Float4, core::load4, core::Mask4, core::splat4;
        Float4 e[3];
        for (int axis = 0; axis < 3; ++axis) {
            const Float4 low = load4(node.low[axis]), high = load4(node.high[axis]);
            const Float4 extent = high - low;
            c[axis] = (low + high) * splat4(0.5f) - m_mid[axis];
            // Empty boxes keep a negative extent and touch nothing.
            e[axis] = extent * splat4(0.5f) + absolute(extent) * splat4(4e-7f) + splat4(m_slack);
        }
        Mask4 touches = load4(node.low[0]) <= load4(node.high[0]);
        for (int axis = 0; axis < 3; ++axis) {
            touches &= absolute(c[axis]) <= e[axis] + m_reach[axis];
        }
        for (int axis = 0; axis < 3; ++axis) {
            const int j = (axis + 1) % 3, k = (axis + 2) % 3;
            const Float4 distance = absolute(c[j] * m_half[k] - c[k] * m_half[j]);
            // The extents already include the slack times the segment's length, which covers the rounding error of this
            // product.
            const Float4 bound = e[j] * m_reach[k] + e[k] * m_reach[j] +
                                 (absolute(c[j]) * m_reach[k] + absolute(c[k]) * m_reach[j]) * splat4(4e-7f);
            touches &= distance <= bound;
        }
        return core::laneBits(touches);
    }

  private:
    Vec3 m_start, m_whole;
    double m_around_mm;
    core::Float4 m_mid[3], m_half[3], m_reach[3];
    float m_slack = 0.0f;
};

} // namespace internal

template<class Leaf>
void BoxHierarchy::visitBox(const Box& box, Leaf&& leaf) const noexcept
{
    if (m_nodes.empty()) {
        return;
    }
    using core::absolute, core::Float4, core::laneBits, core::load4, core::Mask4;
    const auto splat = [](float v) { return core::splat4(v); };
    const FloatBox query = FloatBox::around(box, m_origin);
    const Float4 low0 = splat(query.low[0]), low1 = splat(query.low[1]), low2 = splat(query.low[2]);
    const Float4 high0 = splat(query.high[0]), high1 = splat(query.high[1]), high2 = splat(query.high[2]);
    // Batched traversal: nodes are prefetched when found and tested together, so that their cache misses overlap.
    std::uint32_t stack[kWave * kStack];
    std::uint32_t wave[kWave];
    int top = 0, found = 1;
    wave[0] = 0;
    while (found > 0) {
        for (int i = 0; i < found; ++i) {
            const Node& node = m_nodes[wave[i]];
            const Mask4 touches = (load4(node.low[0]) <= high0) & (load4(node.high[0]) >= low0) &
                                  (load4(node.low[1]) <= high1) & (load4(node.high[1]) >= low1) &
                                  (load4(node.low[2]) <= high2) & (load4(node.high[2]) >= low2);
            std::uint32_t lanes = laneBits(touches);
            for (std::uint32_t leaves = lanes & node.leafMask; leaves != 0; leaves &= leaves - 1) {
                const std::uint32_t child = node.child[std::countr_zero(leaves)];
                if (!leaf(child >> 3, child & 7u)) {
                    return;
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
}

template<class Leaf>
void BoxHierarchy::visitSegment(const Vec3& from, const Vec3& to, Leaf&& leaf, double around_mm) const noexcept
{
    if (m_nodes.empty()) {
        return;
    }
    using core::Float4, core::splat4;
    const Vec3 whole = to - from;
    internal::Segment4 segment(from - m_origin, whole, around_mm);
    const Float4 along0 = splat4(static_cast<float>(whole[0])), along1 = splat4(static_cast<float>(whole[1])),
                 along2 = splat4(static_cast<float>(whole[2]));
    double share = 1.0;
    std::uint32_t stack[kStack];
    int top = 0;
    std::uint32_t current = 0;
    for (;;) {
        const Node& node = m_nodes[current];
        Float4 c[3];
        std::uint32_t lanes = segment.touched(node, c);
        for (std::uint32_t leaves = lanes & node.leafMask; leaves != 0; leaves &= leaves - 1) {
            const std::uint32_t child = node.child[std::countr_zero(leaves)];
            const double left = leaf(child >> 3, child & 7u);
            if (left < share) {
                if (left < 0.0) {
                    return;
                }
                share = left;
                segment.clip(share);
            }
        }
        lanes &= ~node.leafMask;
        if (lanes != 0) {
            top = internal::pushFarthestFirst(node, lanes, c[0] * along0 + c[1] * along1 + c[2] * along2, stack, top);
        }
        if (top == 0) {
            return;
        }
        current = stack[--top];
    }
}

} // namespace palpate::geometry
