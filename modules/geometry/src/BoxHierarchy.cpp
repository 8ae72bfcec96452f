// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/BoxHierarchy.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <thread>

namespace palpate::geometry {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr int kBins = 16;

struct Item
{
    FloatBox box;
    std::uint32_t number;
};

FloatBox emptyBox()
{
    return {{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
}

void extend(FloatBox& a, const FloatBox& b)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        a.low[axis] = std::min(a.low[axis], b.low[axis]);
        a.high[axis] = std::max(a.high[axis], b.high[axis]);
    }
}

float halfArea(const FloatBox& b)
{
    const float x = b.high[0] - b.low[0], y = b.high[1] - b.low[1], z = b.high[2] - b.low[2];
    return x * y + y * z + z * x;
}

float doubledCentre(const FloatBox& b, std::size_t axis)
{
    return b.low[axis] + b.high[axis];
}

/// A node of the binary tree that is built first. A subtree over n items owns the 2 n - 1 slots from its root on:
/// threads never share one, and the tree does not depend on their number.
struct BinaryNode
{
    FloatBox box;
    std::uint32_t first, last;
    std::uint32_t right; ///< slot of the right child; the left one is the next slot; 0: a leaf
};

} // namespace

/// Top-down binned surface-area heuristic (Wald, "On fast construction of SAH-based bounding volume hierarchies",
/// 2007), then two binary levels collapsed into one node of four.
class HierarchyBuilder
{
  public:
    HierarchyBuilder(const std::vector<FloatBox>& boxes, unsigned threads)
        : m_items(boxes.size())
        , m_binary(2 * boxes.size())
        , m_threads(threads)
    {
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            m_items[i] = {boxes[i], static_cast<std::uint32_t>(i)};
        }
    }

    void run(BoxHierarchy& result, std::vector<FloatBox>& boxes, core::LargeArray<std::uint32_t>& numbers)
    {
        split(0, 0, static_cast<std::uint32_t>(m_items.size()), 0);
        result.m_nodes.reserve(m_items.size() / 6 + 8);
        collapse(result.m_nodes, 0);
        result.m_nodes.shrink_to_fit();
        numbers.resize(m_items.size());
        for (std::size_t i = 0; i < m_items.size(); ++i) {
            boxes[i] = m_items[i].box;
            numbers[i] = m_items[i].number;
        }
    }

  private:
    void split(std::uint32_t slot, std::uint32_t first, std::uint32_t last, int depth)
    {
        BinaryNode& node = m_binary[slot];
        FloatBox box = emptyBox(), centres = emptyBox();
        for (std::uint32_t i = first; i < last; ++i) {
            extend(box, m_items[i].box);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const float c = doubledCentre(m_items[i].box, axis);
                centres.low[axis] = std::min(centres.low[axis], c);
                centres.high[axis] = std::max(centres.high[axis], c);
            }
        }
        node = {box, first, last, 0};
        if (last - first <= BoxHierarchy::kLeafSize) {
            return;
        }
        const std::uint32_t middle = partition(centres, first, last, depth);
        node.right = slot + 2 * (middle - first);
        if (m_threads > 1 && depth == 0 && last - first > 20'000) {
            std::thread left([&] { split(slot + 1, first, middle, depth + 1); });
            split(node.right, middle, last, depth + 1);
            left.join();
        } else {
            split(slot + 1, first, middle, depth + 1);
            split(node.right, middle, last, depth + 1);
        }
    }

    /// @return where the right part begins; both parts are at least one leaf where there is enough for it.
    std::uint32_t partition(const FloatBox& centres, std::uint32_t first, std::uint32_t last, int depth)
    {
        const std::uint32_t count = last - first;
        // Past this depth only halving is allowed, which bounds the depth: 32 + log2(2^29) < kMaxDepth.
        if (depth < 32 && count > 8) {
            float bestCost = kInfinity;
            std::size_t bestAxis = 0;
            int bestBin = 0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const float low = centres.low[axis], extent = centres.high[axis] - low;
                if (!(extent > 0.0f)) {
                    continue;
                }
                const float scale = static_cast<float>(kBins) * 0.9999f / extent;
                std::array<FloatBox, kBins> boxes;
                boxes.fill(emptyBox());
                std::array<std::uint32_t, kBins> counts{};
                // A large set is well described by a part of it; which part is fixed, so the tree is too.
                const std::uint32_t stride = count > 65'536 ? count / 16'384 : 1;
                for (std::uint32_t i = first; i < last; i += stride) {
                    const auto bin = static_cast<std::size_t>((doubledCentre(m_items[i].box, axis) - low) * scale);
                    extend(boxes[bin], m_items[i].box);
                    ++counts[bin];
                }
                std::array<float, kBins> leftCost;
                FloatBox sweep = emptyBox();
                std::uint32_t n = 0;
                for (std::size_t b = 0; b + 1 < kBins; ++b) {
                    extend(sweep, boxes[b]);
                    n += counts[b];
                    leftCost[b] = n == 0 ? kInfinity : halfArea(sweep) * static_cast<float>(n);
                }
                sweep = emptyBox();
                n = 0;
                for (std::size_t b = kBins - 1; b > 0; --b) {
                    extend(sweep, boxes[b]);
                    n += counts[b];
                    const float cost = n == 0 ? kInfinity : leftCost[b - 1] + halfArea(sweep) * static_cast<float>(n);
                    if (cost < bestCost) {
                        bestCost = cost;
                        bestAxis = axis;
                        bestBin = static_cast<int>(b);
                    }
                }
            }
            if (bestCost < kInfinity) {
                const float low = centres.low[bestAxis];
                const float scale = static_cast<float>(kBins) * 0.9999f / (centres.high[bestAxis] - low);
                const auto begin = m_items.begin() + first;
                const auto middle = std::partition(begin, m_items.begin() + last, [&](const Item& item) {
                    return static_cast<int>((doubledCentre(item.box, bestAxis) - low) * scale) < bestBin;
                });
                const auto left = static_cast<std::uint32_t>(middle - begin);
                if (left > 0 && left < count) {
                    return first + left;
                }
            }
        }
        return halve(centres, first, last);
    }

    /// Halves along the longest axis; the left half is a whole number of leaves.
    std::uint32_t halve(const FloatBox& centres, std::uint32_t first, std::uint32_t last)
    {
        std::size_t axis = 0;
        for (std::size_t a = 1; a < 3; ++a) {
            if (centres.high[a] - centres.low[a] > centres.high[axis] - centres.low[axis]) {
                axis = a;
            }
        }
        const std::uint32_t count = last - first;
        const std::uint32_t left =
            (count / 2 + BoxHierarchy::kLeafSize - 1) / BoxHierarchy::kLeafSize * BoxHierarchy::kLeafSize;
        const std::uint32_t middle = first + (left < count ? left : count / 2);
        std::nth_element(m_items.begin() + first, m_items.begin() + middle, m_items.begin() + last,
                         [axis](const Item& a, const Item& b) {
                             const float ca = doubledCentre(a.box, axis), cb = doubledCentre(b.box, axis);
                             return ca != cb ? ca < cb : a.number < b.number;
                         });
        return middle;
    }

    std::uint32_t collapse(core::LargeArray<BoxHierarchy::Node>& nodes, std::uint32_t slot)
    {
        const auto index = static_cast<std::uint32_t>(nodes.size());
        nodes.emplace_back();
        std::array<std::uint32_t, 4> children{slot, 0, 0, 0};
        std::size_t count = 1;
        // Open the child with the largest surface until there are four.
        while (count < 4) {
            std::size_t open = 4;
            float largest = -1.0f;
            for (std::size_t i = 0; i < count; ++i) {
                const BinaryNode& child = m_binary[children[i]];
                if (child.right != 0 && halfArea(child.box) > largest) {
                    largest = halfArea(child.box);
                    open = i;
                }
            }
            if (open == 4) {
                break;
            }
            const std::uint32_t opened = children[open];
            for (std::size_t i = count; i > open + 1; --i) {
                children[i] = children[i - 1];
            }
            children[open] = opened + 1;
            children[open + 1] = m_binary[opened].right;
            ++count;
        }
        for (std::size_t i = 0; i < 4; ++i) {
            const FloatBox box = i < count ? m_binary[children[i]].box : emptyBox();
            for (std::size_t axis = 0; axis < 3; ++axis) {
                nodes[index].low[axis][i] = i < count ? box.low[axis] : std::numeric_limits<float>::max();
                nodes[index].high[axis][i] = i < count ? box.high[axis] : -std::numeric_limits<float>::max();
            }
        }
        for (std::size_t i = 0; i < count; ++i) {
            const BinaryNode& child = m_binary[children[i]];
            if (child.right == 0) {
                nodes[index].child[i] = child.first << 3 | (child.last - child.first);
                nodes[index].leafMask |= 1u << i;
            } else {
                const std::uint32_t inner = collapse(nodes, children[i]);
                nodes[index].child[i] = inner;
            }
        }
        return index;
    }

    std::vector<Item> m_items;
    std::vector<BinaryNode> m_binary;
    unsigned m_threads;
};

BoxHierarchy BoxHierarchy::build(std::vector<FloatBox>& boxes, core::LargeArray<std::uint32_t>& items,
                                 const Vec3& origin, unsigned threads)
{
    BoxHierarchy result;
    result.m_origin = origin;
    items.clear();
    if (!boxes.empty()) {
        HierarchyBuilder(boxes, threads).run(result, boxes, items);
    }
    return result;
}

} // namespace palpate::geometry
