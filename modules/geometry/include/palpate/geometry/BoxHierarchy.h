// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/// A box as floats relative to a hierarchy's origin, rounded outwards: it contains what it was made from. [mm]
struct FloatBox
{
    std::array<float, 3> low;
    std::array<float, 3> high;

    /// @return the smallest such box around `box - origin`.
    [[nodiscard]] static FloatBox around(const Box& box, const Vec3& origin) noexcept PALPATE_NONBLOCKING;
};

inline FloatBox FloatBox::around(const Box& box, const Vec3& origin) noexcept
{
    // Two ulp outwards: one for the conversion to float, one for the arithmetic itself. The constant keeps zero out.
    constexpr float kOutwards = 2.4e-7f;
    constexpr float kTiny = 1e-30f;
    FloatBox result;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const auto low = static_cast<float>(box.min()[axis] - origin[axis]);
        const auto high = static_cast<float>(box.max()[axis] - origin[axis]);
        result.low[i] = low - (std::fabs(low) * kOutwards + kTiny);
        result.high[i] = high + (std::fabs(high) * kOutwards + kTiny);
    }
    return result;
}

/// A box and what it is around, as BoxHierarchy::build sorts them: two registers long.
struct alignas(16) BoxedItem
{
    std::array<float, 3> low;
    std::uint32_t number; ///< of the item
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

/// What is still of interest to BoxHierarchy::visitSwept.
struct SweptInterest
{
    double share = 1.0;  ///< of the segment: what is met wholly beyond is left out; less than 0 ends the traversal
    double cosine = 0.0; ///< to the segment, as seen from its start: what lies wholly at smaller ones is left out
};

/// A bounding-volume hierarchy of four children a node over any boxes: the triangles of a surface, or the structures of
/// a layer. Built once in O(n log n), read-only after that: any number of threads may query it. Its traversals are
/// Palpate's own and not installed (Inside.h and SurfaceExamination.h ask it for others): a source that makes one
/// includes the internal header that defines it.
class BoxHierarchy
{
  public:
    /// Four child boxes, side by side, so that one comparison serves all four. An unused child has an empty box.
    struct alignas(64) Node
    {
        float low[3][4];  ///< [mm] by axis, then child
        float high[3][4]; ///< [mm]
        /// Inner child: index of its node. Leaf: first item << 3 | number of items (1 … 4).
        std::uint32_t child[4];
        std::uint32_t leafMask; ///< bit i: child i is a leaf
        std::uint32_t unused[3];
    };
    static_assert(sizeof(Node) == 128);

    /// Items in a leaf, at most.
    static constexpr std::uint32_t kLeafSize = 4;
    /// Items in a hierarchy, at most: three bits of a child hold the leaf's count.
    static constexpr std::size_t kMaxItems = std::size_t{1} << 29;

    /// Builds over `items`; the result does not depend on the number of threads.
    /// @param items    reordered: on return they are in the order of the leaves
    /// @param origin   what the boxes are relative to, in the frame of the queries [mm]
    /// @param threads  at most
    [[nodiscard]] static BoxHierarchy build(std::span<BoxedItem> items, const Vec3& origin, unsigned threads);

    /// Calls `leaf(first, count)` for each leaf whose box touches `box`, in a fixed order, until it returns false.
    /// @par Real-time Wait-free; bounded by the number of nodes.
    template<class Leaf>
    void visitBox(const Box& box, Leaf&& leaf) const noexcept PALPATE_NONBLOCKING;

    /// Calls `leaf(first, count)` for the leaves whose box a segment touches, nearer ones first as a rule. `leaf`
    /// returns the share of the segment, 0 … 1, that is still of interest; what lies wholly beyond is left out. A
    /// negative share ends the traversal.
    /// @param around_mm  how far beside the segment a box may lie
    /// @par Source Segment against box by separating axes: Ericson, Real-Time Collision Detection (2005), 5.3.3.
    /// @par Real-time Wait-free; bounded by the number of nodes.
    template<class Leaf>
    void visitSegment(const Vec3& from, const Vec3& to, Leaf&& leaf,
                      double around_mm = 0.0) const noexcept PALPATE_NONBLOCKING;

    /// Calls `leaf(first, count)` for the leaves that a ball of `reach_mm` may touch whose centre goes along a segment,
    /// nearer ones first as a rule: by the distance of their boxes, less what rounding could make of it. Left out is
    /// what lies wholly behind the start, too: from there on its distance only grows. `leaf` returns what is still of
    /// interest.
    /// @param interest  at first; with a cosine above 0 the share is 0
    /// @param nodes  counted down for each node; the traversal ends where it comes to 0
    /// @return how far along the segment nothing is met of what was left unvisited; infinite when all was visited [mm]
    /// @par Real-time Wait-free; bounded by `nodes`.
    template<class Leaf>
    [[nodiscard]] double visitSwept(const Vec3& from, const Vec3& to, double reach_mm, SweptInterest interest,
                                    std::uint32_t& nodes, Leaf&& leaf) const noexcept PALPATE_NONBLOCKING;

    /// Calls `leaf(first, count)` for each leaf whose box comes within `reach_mm` of a point, in a fixed order, until
    /// it returns false. @return how many nodes were visited.
    /// @par Real-time Wait-free; bounded by the number of nodes.
    template<class Leaf>
    std::uint32_t visitAround(const Vec3& p, double reach_mm, Leaf&& leaf) const noexcept PALPATE_NONBLOCKING;

    /// Calls `pair(thread, first, count, otherFirst, otherCount)` once for each two leaves whose boxes come within
    /// `around_mm` of each other, a leaf and itself among them: in no fixed order, from several threads at once. A
    /// thread ends when `pair` returns false to it.
    /// @param threads  at most; `pair` is told which one calls, from 0
    template<class Pair>
    void visitPairs(double around_mm, unsigned threads, Pair&& pair) const;

    [[nodiscard]] const Vec3& origin() const noexcept { return m_origin; }
    [[nodiscard]] std::size_t byteSize() const noexcept { return m_nodes.capacity() * sizeof(Node); }
    [[nodiscard]] std::size_t nodeCount() const noexcept { return m_nodes.size(); }

  private:
    // Depth of the binary tree is bounded by the builder (see BoxHierarchy.cpp); each level leaves at most three
    // siblings waiting.
    static constexpr int kMaxDepth = 64;
    static constexpr int kStack = 3 * kMaxDepth + 4;
    static constexpr int kWave = 8; ///< nodes that are looked at together

    core::LargeArray<Node> m_nodes; ///< [0] is the root; empty without items
    Vec3 m_origin = Vec3::Zero();

    friend class HierarchyBuilder;
};

} // namespace palpate::geometry
