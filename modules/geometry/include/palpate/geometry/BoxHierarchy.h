// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/LargeArray.h>
#include <palpate/core/Realtime.h>
#include <palpate/core/Types.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace palpate::geometry {

using core::Box;
using core::Vec3;

/// Single-precision box relative to a hierarchy's origin, rounded outwards so that the original box is contained. [mm]
struct FloatBox
{
    std::array<float, 3> low;
    std::array<float, 3> high;

    /// @return the smallest FloatBox around `box - origin`.
    [[nodiscard]] static FloatBox around(const Box& box, const Vec3& origin) noexcept PALPATE_NONBLOCKING;
};

inline FloatBox FloatBox::around(const Box& box, const Vec3& origin) noexcept
{
    // Two ulp outwards: one for the conversion to float, one for this arithmetic. kTiny handles coordinates of exactly
    // zero.
    constexpr float kRelativeMargin = 2.4e-7f;
    constexpr float kTiny = 1e-30f;
    FloatBox result;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const auto low = static_cast<float>(box.min()[axis] - origin[axis]);
        const auto high = static_cast<float>(box.max()[axis] - origin[axis]);
        result.low[i] = low - (std::fabs(low) * kRelativeMargin + kTiny);
        result.high[i] = high + (std::fabs(high) * kRelativeMargin + kTiny);
    }
    return result;
}

/// A box and the number of its item, in the form that BoxHierarchy::build sorts. Fits two SSE registers.
struct alignas(16) BoxedItem
{
    std::array<float, 3> low;
    std::uint32_t number; ///< index of the item
    std::array<float, 3> high;
    std::uint32_t unused = 0;

    BoxedItem() = default;
    BoxedItem(const FloatBox& box, std::uint32_t itemNumber)
        : low(box.low)
        , number(itemNumber)
        , high(box.high)
    {
    }
};

/// Pruning state of BoxHierarchy::visitSwept, returned by the leaf visitor.
struct SweptPruning
{
    double share = 1.0; ///< fraction of the segment still to be searched (0 to 1); a negative value ends the traversal
    /// Smallest cosine to the segment direction, seen from its start; boxes entirely below are skipped.
    double cosine = 0.0;
};

/// Four-wide bounding volume hierarchy over arbitrary boxes: the triangles of a surface, or the structures of a layer.
/// Built once in O(n log n) and read-only afterwards, so any number of threads may query a hierarchy. The traversal
/// templates are internal and not installed: a Palpate source that calls one includes the internal header with the
/// definition. External callers use Inside.h and SurfaceExamination.h.
class PALPATE_EXPORT BoxHierarchy
{
  public:
    /// Four child boxes in structure-of-arrays layout for SIMD tests of all four at once. An unused child has an empty
    /// box.
    struct alignas(64) Node
    {
        float low[3][4];  ///< [mm], by axis, then child
        float high[3][4]; ///< [mm]
        /// Inner child: node index. Leaf: first item << 3 | number of items (1 to 4).
        std::uint32_t child[4];
        std::uint32_t leafMask; ///< bit i: child i is a leaf
        std::uint32_t unused[3];
    };
    static_assert(sizeof(Node) == 128);

    /// Maximum number of items in a leaf.
    static constexpr std::uint32_t kLeafSize = 4;
    /// Maximum number of items in a hierarchy: three bits of a child index hold the item count of the leaf.
    static constexpr std::size_t kMaxItems = std::size_t{1} << 29;

    /// Builds a hierarchy over `items`. The result does not depend on the number of threads.
    /// @param items    sorted in place into the order of the leaves
    /// @param origin   origin of the boxes in the frame of the queries [mm]
    /// @param threads  maximum number of threads
    [[nodiscard]] static BoxHierarchy build(std::span<BoxedItem> items, const Vec3& origin, unsigned threads);

    /// Calls `leaf(first, count)` for each leaf whose box touches `box`, in a fixed order, until `leaf` returns false.
    /// @par Real-time Wait-free; bounded by the number of nodes.
    template<class Leaf>
    void visitBox(const Box& box, Leaf&& leaf) const noexcept PALPATE_NONBLOCKING;

    /// Calls `leaf(first, count)` for the leaves whose boxes a segment touches, approximately from near to far. `leaf`
    /// returns the fraction of the segment (0 to 1) that is still to be searched; boxes entirely beyond are skipped. A
    /// negative value ends the traversal.
    /// @param around_mm  distance from the segment within which a box counts as touched
    /// @par Source Segment against box by separating axes: Ericson, Real-Time Collision Detection (2005), 5.3.3.
    /// @par Real-time Wait-free; bounded by the number of nodes.
    template<class Leaf>
    void visitSegment(const Vec3& from, const Vec3& to, Leaf&& leaf,
                      double around_mm = 0.0) const noexcept PALPATE_NONBLOCKING;

    /// Calls `leaf(first, count)` for the leaves that a ball of radius `reach_mm` may touch while its centre moves
    /// along a segment, approximately from near to far. Box distances are reduced by the rounding error, so no leaf is
    /// missed. Boxes entirely behind the start are skipped, because the ball only moves away from them. `leaf` returns
    /// the updated pruning state.
    /// @param interest  initial pruning state; with a cosine above 0 the share must be 0
    /// @param nodes  node budget, decremented for each visited node; the traversal ends at 0
    /// @return a distance along the segment that is free of contact with the unvisited items; infinite if the traversal
    /// was complete [mm]
    /// @par Real-time Wait-free; bounded by `nodes`.
    template<class Leaf>
    [[nodiscard]] double visitSwept(const Vec3& from, const Vec3& to, double reach_mm, SweptPruning interest,
                                    std::uint32_t& nodes, Leaf&& leaf) const noexcept PALPATE_NONBLOCKING;

    /// Calls `leaf(first, count)` for each leaf whose box is within `reach_mm` of a point, in a fixed order, until
    /// `leaf` returns false.
    /// @return the number of visited nodes
    /// @par Real-time Wait-free; bounded by the number of nodes.
    template<class Leaf>
    std::uint32_t visitAround(const Vec3& p, double reach_mm, Leaf&& leaf) const noexcept PALPATE_NONBLOCKING;

    /// Calls `pair(thread, first, count, otherFirst, otherCount)` once for each pair of leaves whose boxes are within
    /// `around_mm` of each other, including each leaf with itself. Calls come in no fixed order and from several
    /// threads concurrently. A thread ends when `pair` returns false.
    /// @param threads  maximum number of threads; `pair` receives the index of the calling thread, from 0
    template<class Pair>
    void visitPairs(double around_mm, unsigned threads, Pair&& pair) const;

    [[nodiscard]] const Vec3& origin() const noexcept { return m_origin; }
    [[nodiscard]] std::size_t byteSize() const noexcept { return m_nodes.capacity() * sizeof(Node); }
    [[nodiscard]] std::size_t nodeCount() const noexcept { return m_nodes.size(); }

  private:
    // The builder bounds the depth of the binary tree (see BoxHierarchy.cpp). Each level leaves at most three siblings
    // on the stack.
    static constexpr int kMaxDepth = 64;
    static constexpr int kStack = 3 * kMaxDepth + 4;
    static constexpr int kWave = 8; ///< nodes per prefetch batch

    core::LargeArray<Node> m_nodes; ///< [0] is the root; empty without items
    Vec3 m_origin = Vec3::Zero();

    friend class HierarchyBuilder;
};

} // namespace palpate::geometry
