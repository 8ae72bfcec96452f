// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/BoxHierarchy.h"

#include <palpate/core/Float4.h>
#include <palpate/core/Parallel.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <limits>
#include <vector>

namespace palpate::geometry {

namespace {

using core::Float4;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr int kBins = 16;
constexpr int kFewBins = 8;             // bin count for small ranges
constexpr std::uint32_t kFew = 2048;    // ranges up to this size evaluate all items
constexpr std::uint32_t kMany = 20'000; // minimum number of items for a multithreaded build

/// Box in two SIMD registers; the fourth lanes are undefined.
struct Box4
{
    Float4 low = core::splat4(kInfinity);
    Float4 high = core::splat4(-kInfinity);

    void extend(const Box4& b)
    {
        low = core::least(low, b.low);
        high = core::greatest(high, b.high);
    }
    [[nodiscard]] float halfArea() const
    {
        const Float4 size = high - low;
        return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
    }
};

Box4 boxOf(const BoxedItem& item)
{
    static_assert(sizeof(BoxedItem) == 2 * sizeof(Float4));
    const auto* lanes = reinterpret_cast<const char*>(&item);
    Box4 box;
    std::memcpy(&box.low, lanes, sizeof box.low);
    std::memcpy(&box.high, lanes + sizeof box.low, sizeof box.high);
    return box;
}

/// Twice the centre of an item's box; the fourth lane is zero.
Float4 doubledCentre(const BoxedItem& item)
{
    const Box4 box = boxOf(item);
    const auto three = [](Float4 v) { return __builtin_shufflevector(v, Float4{}, 0, 1, 2, 4); };
    return three(box.low) + three(box.high);
}

/// Contiguous range of items with bounds.
struct Range
{
    std::uint32_t first, last;
    int depth; ///< number of splits above
    Box4 box, centres;

    [[nodiscard]] std::uint32_t count() const { return last - first; }
};

} // namespace

/// Top-down build with a binned surface area heuristic (Wald, "On fast construction of SAH-based bounding volume
/// hierarchies", 2007). The child with the largest surface area is split until a node has four children.
class HierarchyBuilder
{
  public:
    using Node = BoxHierarchy::Node;
    using Nodes = core::LargeArray<Node>;

    explicit HierarchyBuilder(std::span<BoxedItem> items)
        : m_items(items)
    {
    }

    void run(Nodes& nodes, unsigned threads)
    {
        const auto count = static_cast<std::uint32_t>(m_items.size());
        if (count < kMany) {
            nodes.reserve(likelyNodes(count));
            add(range(0, count, 0), nodes);
        } else {
            addMany(count, threads, nodes);
        }
        nodes.shrink_to_fit();
    }

  private:
    static std::size_t likelyNodes(std::uint32_t items) { return items / 6 + 8; }

    [[nodiscard]] Range range(std::uint32_t first, std::uint32_t last, int depth) const
    {
        Range result{first, last, depth, {}, {}};
        for (std::uint32_t i = first; i < last; ++i) {
            result.box.extend(boxOf(m_items[i]));
            const Float4 c = doubledCentre(m_items[i]);
            result.centres.extend({c, c});
        }
        return result;
    }

    /// Up to four subranges of a range, in item order.
    struct Parts
    {
        std::array<Range, 4> part;
        std::size_t count = 1;
    };

    Parts divide(const Range& whole)
    {
        Parts parts;
        parts.part[0] = whole;
        while (parts.count < 4) {
            std::size_t open = 4;
            float largest = -1.0f;
            for (std::size_t i = 0; i < parts.count; ++i) {
                const Range& part = parts.part[i];
                if (part.count() > BoxHierarchy::kLeafSize && part.box.halfArea() > largest) {
                    largest = part.box.halfArea();
                    open = i;
                }
            }
            if (open == 4) {
                break;
            }
            const Range opened = parts.part[open];
            const std::uint32_t middle = partition(opened.centres, opened.first, opened.last, opened.depth);
            for (std::size_t i = parts.count; i > open + 1; --i) {
                parts.part[i] = parts.part[i - 1];
            }
            parts.part[open] = range(opened.first, middle, opened.depth + 1);
            parts.part[open + 1] = range(middle, opened.last, opened.depth + 1);
            ++parts.count;
        }
        return parts;
    }

    /// Creates a node for these parts; indices of inner children are set later.
    static Node nodeOf(const Parts& parts)
    {
        Node node{};
        for (std::size_t i = 0; i < 4; ++i) {
            const bool isUsed = i < parts.count && parts.part[i].count() > 0;
            const Range& part = parts.part[isUsed ? i : 0];
            for (int axis = 0; axis < 3; ++axis) {
                node.low[axis][i] = isUsed ? part.box.low[axis] : std::numeric_limits<float>::max();
                node.high[axis][i] = isUsed ? part.box.high[axis] : -std::numeric_limits<float>::max();
            }
            if (isUsed && part.count() <= BoxHierarchy::kLeafSize) {
                node.child[i] = part.first << 3 | part.count();
                node.leafMask |= 1u << i;
            }
        }
        return node;
    }

    /// Adds the subtree of a range. @return index of its root node.
    std::uint32_t add(const Range& whole, Nodes& nodes)
    {
        const Parts parts = divide(whole);
        const auto index = static_cast<std::uint32_t>(nodes.size());
        nodes.push_back(nodeOf(parts));
        for (std::size_t i = 0; i < parts.count; ++i) {
            if (parts.part[i].count() > BoxHierarchy::kLeafSize) {
                const std::uint32_t child = add(parts.part[i], nodes);
                nodes[index].child[i] = child;
            }
        }
        return index;
    }

    /// Bounds of all items.
    Range whole(std::uint32_t count, unsigned threads) const
    {
        constexpr std::size_t kPieces = 64;
        std::vector<Range> pieces(kPieces);
        const auto end = [count](std::size_t piece) { return static_cast<std::uint32_t>(piece * count / kPieces); };
        core::parallelFor(
            kPieces, [&](std::size_t i, unsigned /*thread*/) { pieces[i] = range(end(i), end(i + 1), 0); }, threads);
        Range all{0, count, 0, {}, {}};
        for (const Range& piece : pieces) {
            all.box.extend(piece.box);
            all.centres.extend(piece.centres);
        }
        return all;
    }

    /// Node near the root; its children are further branches, or subtrees built by one thread.
    struct Branch
    {
        Parts parts;
        std::array<std::uint32_t, 4> below{}; ///< index of a branch, or of a tree with kTree set
        std::uint32_t place = 0;              ///< index of its node
    };
    static constexpr std::uint32_t kTree = 0x80000000u;
    struct Tree
    {
        Range range;
        Nodes nodes;
        std::uint32_t place = 0; ///< index of its first node
    };
    /// Upper part of a hierarchy; each branch precedes its descendants.
    struct UpperTree
    {
        std::vector<Branch> branches;
        std::vector<Tree> trees;
    };

    /// Splits the root of a large hierarchy: once over all items, then both halves in parallel.
    Parts divideRoot(std::uint32_t count, unsigned threads)
    {
        const Range all = whole(count, threads);
        const std::uint32_t middle = partition(all.centres, 0, count, 0);
        Parts root;
        root.count = 4;
        core::parallelFor(
            2,
            [&](std::size_t i, unsigned /*thread*/) {
                const Range half = i == 0 ? range(0, middle, 1) : range(middle, count, 1);
                const std::uint32_t cut = partition(half.centres, half.first, half.last, half.depth);
                root.part[2 * i] = range(half.first, cut, half.depth + 1);
                root.part[2 * i + 1] = range(cut, half.last, half.depth + 1);
            },
            threads);
        return root;
    }

    /// Splits all ranges with more than `most` items, level by level.
    UpperTree splitUpperTree(std::uint32_t count, std::uint32_t most, unsigned threads)
    {
        UpperTree crown;
        crown.branches.push_back({divideRoot(count, threads), {}, 0});
        for (std::size_t first = 0, last = 1; first < last; first = last, last = crown.branches.size()) {
            std::vector<Range> open;
            for (std::size_t b = first; b < last; ++b) {
                for (std::size_t i = 0; i < crown.branches[b].parts.count; ++i) {
                    const Range& part = crown.branches[b].parts.part[i];
                    if (part.count() > most) {
                        crown.branches[b].below[i] = static_cast<std::uint32_t>(last + open.size());
                        open.push_back(part);
                    } else if (part.count() > BoxHierarchy::kLeafSize) {
                        crown.branches[b].below[i] = static_cast<std::uint32_t>(crown.trees.size()) | kTree;
                        crown.trees.push_back({part, {}, 0});
                    }
                }
            }
            crown.branches.resize(last + open.size());
            core::parallelFor(
                open.size(),
                [&](std::size_t i, unsigned /*thread*/) { crown.branches[last + i].parts = divide(open[i]); }, threads);
        }
        return crown;
    }

    /// Assigns node indices to a branch and its descendants in the order of `add`. @return next free index
    static std::uint32_t place(UpperTree& crown, std::uint32_t branch, std::uint32_t next)
    {
        crown.branches[branch].place = next++;
        for (std::size_t i = 0; i < crown.branches[branch].parts.count; ++i) {
            const std::uint32_t below = crown.branches[branch].below[i];
            if ((below & kTree) != 0) {
                Tree& tree = crown.trees[below & ~kTree];
                tree.place = next;
                next += static_cast<std::uint32_t>(tree.nodes.size());
            } else if (below != 0) {
                next = place(crown, below, next);
            }
        }
        return next;
    }

    /// Builds a large hierarchy in parallel. Neither the partition of the items nor the node indices depend on the
    /// number of threads.
    void addMany(std::uint32_t count, unsigned threads, Nodes& nodes)
    {
        constexpr std::uint32_t kTrees = 128; // several per thread for load balancing
        UpperTree crown = splitUpperTree(count, std::max(kMany / 4, count / kTrees), threads);
        core::parallelFor(
            crown.trees.size(),
            [&](std::size_t i, unsigned /*thread*/) {
                Tree& tree = crown.trees[i];
                tree.nodes.reserve(likelyNodes(tree.range.count()));
                add(tree.range, tree.nodes);
            },
            threads);
        nodes.resize(place(crown, 0, 0));
        for (const Branch& branch : crown.branches) {
            Node& node = nodes[branch.place] = nodeOf(branch.parts);
            for (std::size_t i = 0; i < branch.parts.count; ++i) {
                const std::uint32_t below = branch.below[i];
                if (below != 0) {
                    node.child[i] =
                        (below & kTree) != 0 ? crown.trees[below & ~kTree].place : crown.branches[below].place;
                }
            }
        }
        core::parallelFor(
            crown.trees.size(),
            [&](std::size_t t, unsigned /*thread*/) {
                Tree& tree = crown.trees[t];
                Node* to = nodes.data() + tree.place;
                for (Node node : tree.nodes) {
                    for (std::size_t i = 0; i < 4; ++i) {
                        const bool isInner = node.child[i] != 0 && (node.leafMask >> i & 1u) == 0;
                        node.child[i] += isInner ? tree.place : 0;
                    }
                    *to++ = node;
                }
                Nodes().swap(tree.nodes);
            },
            threads);
    }

    /// Split position between two bins along an axis.
    struct Cut
    {
        float cost = kInfinity;
        std::size_t axis = 0;
        int bin = 0; ///< first bin of the right part
    };

    /// @return a function that computes an item's bin along an axis.
    static auto binsAlong(std::size_t axis, const Box4& centres, int bins)
    {
        return
            [axis, low = centres.low[axis],
             scale = static_cast<float>(bins) * 0.9999f / (centres.high - centres.low)[axis]](const BoxedItem& item) {
                return static_cast<int>((item.low[axis] + item.high[axis] - low) * scale);
            };
    }

    /// Replaces `best` by the cheapest split along an axis if its cost is lower.
    /// @param stride  step between evaluated items
    void findCut(const Box4& centres, std::uint32_t first, std::uint32_t last, std::uint32_t stride, std::size_t axis,
                 int bins, Cut& best) const
    {
        std::array<Box4, kBins> boxes;
        std::array<std::uint32_t, kBins> counts{};
        const auto binOf = binsAlong(axis, centres, bins);
        for (std::uint32_t i = first; i < last; i += stride) {
            const auto bin = static_cast<std::size_t>(binOf(m_items[i]));
            boxes[bin].extend(boxOf(m_items[i]));
            ++counts[bin];
        }
        std::array<float, kBins> leftCost;
        Box4 sweep;
        std::uint32_t n = 0;
        for (int b = 0; b + 1 < bins; ++b) {
            sweep.extend(boxes[static_cast<std::size_t>(b)]);
            n += counts[static_cast<std::size_t>(b)];
            leftCost[static_cast<std::size_t>(b)] = n == 0 ? kInfinity : sweep.halfArea() * static_cast<float>(n);
        }
        sweep = Box4();
        n = 0;
        for (int b = bins - 1; b > 0; --b) {
            sweep.extend(boxes[static_cast<std::size_t>(b)]);
            n += counts[static_cast<std::size_t>(b)];
            const float cost =
                n == 0 ? kInfinity
                       : leftCost[static_cast<std::size_t>(b - 1)] + sweep.halfArea() * static_cast<float>(n);
            if (cost < best.cost) {
                best = {cost, axis, b};
            }
        }
    }

    /// @return start of the right part; both parts contain at least one full leaf if there are enough items.
    std::uint32_t partition(const Box4& centres, std::uint32_t first, std::uint32_t last, int depth)
    {
        const std::uint32_t count = last - first;
        // Below this depth only median splits are used, which bounds the depth: 32 + log2(2^29) < kMaxDepth.
        if (depth < 32 && count > 8) {
            const Float4 extent = centres.high - centres.low;
            const std::size_t longest = longestOf(extent);
            const int bins = count > kBins * kBins ? kBins : kFewBins;
            // Large ranges are evaluated on a subset of their items, chosen deterministically. For small ranges the
            // longest axis is nearly always the best.
            const std::uint32_t stride = count > kFew ? count / (kFew / 2) : 1;
            const std::size_t firstAxis = count > kFew ? 0 : longest, lastAxis = count > kFew ? 2 : longest;
            Cut best;
            for (std::size_t axis = firstAxis; axis <= lastAxis; ++axis) {
                if (extent[axis] > 0.0f) {
                    findCut(centres, first, last, stride, axis, bins, best);
                }
            }
            if (best.cost < kInfinity) {
                const std::span<BoxedItem> items = m_items.subspan(first, count);
                const auto isLeft = [binOf = binsAlong(best.axis, centres, bins),
                                     bin = best.bin](const BoxedItem& item) { return binOf(item) < bin; };
                const auto left = static_cast<std::uint32_t>(
                    count > kFew ? std::partition(items.begin(), items.end(), isLeft) - items.begin()
                                 : partitionFew(items, isLeft));
                if (left > 0 && left < count) {
                    return first + left;
                }
            }
        }
        return halve(centres, first, last);
    }

    /// As std::partition, without its frequently mispredicted branch. Not inlined, so that the stack buffer is not part
    /// of each recursion level of `add`.
    /// @return size of the left part.
    template<class IsLeft>
    [[gnu::noinline]] static std::size_t partitionFew(std::span<BoxedItem> items, IsLeft&& isLeft)
    {
        struct Bytes // raw storage of an item, left uninitialised
        {
            std::byte all[sizeof(BoxedItem)];
        };
        alignas(64) std::array<Bytes, kFew> right;
        std::size_t lefts = 0, rights = 0;
        for (const BoxedItem& item : items) {
            const std::size_t isOneLeft = isLeft(item) ? 1 : 0;
            const Bytes bytes = std::bit_cast<Bytes>(item);
            right[rights] = bytes;
            items[lefts] = item;
            lefts += isOneLeft;
            rights += 1 - isOneLeft;
        }
        for (std::size_t i = 0; i < rights; ++i) {
            items[lefts + i] = std::bit_cast<BoxedItem>(right[i]);
        }
        return lefts;
    }

    static std::size_t longestOf(Float4 extent)
    {
        std::size_t longest = 0;
        for (std::size_t axis = 1; axis < 3; ++axis) {
            longest = extent[axis] > extent[longest] ? axis : longest;
        }
        return longest;
    }

    /// Median split along the longest axis; the left part is a whole number of leaves.
    std::uint32_t halve(const Box4& centres, std::uint32_t first, std::uint32_t last)
    {
        const std::size_t axis = longestOf(centres.high - centres.low);
        const std::uint32_t count = last - first;
        const std::uint32_t left =
            (count / 2 + BoxHierarchy::kLeafSize - 1) / BoxHierarchy::kLeafSize * BoxHierarchy::kLeafSize;
        const std::uint32_t middle = first + (left < count ? left : count / 2);
        std::nth_element(m_items.begin() + first, m_items.begin() + middle, m_items.begin() + last,
                         [axis](const BoxedItem& a, const BoxedItem& b) {
                             const float ca = doubledCentre(a)[axis], cb = doubledCentre(b)[axis];
                             return ca != cb ? ca < cb : a.number < b.number;
                         });
        return middle;
    }

    std::span<BoxedItem> m_items;
};

BoxHierarchy BoxHierarchy::build(std::span<BoxedItem> items, const Vec3& origin, unsigned threads)
{
    BoxHierarchy result;
    result.m_origin = origin;
    if (!items.empty()) {
        HierarchyBuilder(items).run(result.m_nodes, threads);
    }
    return result;
}

} // namespace palpate::geometry
