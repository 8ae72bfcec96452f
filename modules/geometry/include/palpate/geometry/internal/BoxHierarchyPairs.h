// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// BoxHierarchy::visitPairs: to be included where it is called.

#include "palpate/geometry/BoxHierarchy.h"

#include <palpate/core/Float4.h>

#include <array>
#include <atomic>
#include <bit>
#include <future>
#include <vector>

namespace palpate::geometry {

/// Pairs of nodes, or of a leaf and a node, that are still to be opened.
template<class Pair>
class PairVisit
{
  public:
    using Node = BoxHierarchy::Node;

    PairVisit(const Node* nodes, float around, unsigned thread, Pair& pair)
        : m_nodes(nodes)
        , m_around(core::splat4(around))
        , m_thread(thread)
        , m_pair(pair)
    {
    }

    /// Opens node `a` and node `b`, or one node with itself. @param next  called for pairs of nodes to be opened next
    template<class Next>
    void open(std::uint32_t a, std::uint32_t b, Next&& next)
    {
        const Node& p = m_nodes[a];
        const Node& q = m_nodes[b];
        for (std::uint32_t i = 0; i < 4; ++i) {
            if (p.low[0][i] > p.high[0][i]) {
                continue; // unused
            }
            // Of a node and itself each pair once.
            const std::uint32_t wanted = a == b ? 0xfu << i & 0xfu : 0xfu;
            const bool isLeaf = (p.leafMask >> i & 1u) != 0;
            for (std::uint32_t lanes = touching(p, i, q) & wanted; lanes != 0; lanes &= lanes - 1) {
                const auto j = static_cast<std::uint32_t>(std::countr_zero(lanes));
                const bool isOtherLeaf = (q.leafMask >> j & 1u) != 0;
                if (isLeaf && isOtherLeaf) {
                    call(p.child[i], q.child[j]);
                } else if (isLeaf) {
                    openLeaf(p, i, q.child[j]);
                } else if (isOtherLeaf) {
                    openLeaf(q, j, p.child[i]);
                } else {
                    next(p.child[i], q.child[j]);
                }
                if (m_isOver) {
                    return;
                }
            }
        }
    }

    void openAll(std::uint32_t a, std::uint32_t b)
    {
        open(a, b, [this](std::uint32_t c, std::uint32_t d) { openAll(c, d); });
    }

    [[nodiscard]] bool isOver() const { return m_isOver; }

  private:
    [[nodiscard]] std::uint32_t touching(const Node& p, std::uint32_t i, const Node& q) const
    {
        core::Mask4 touches{-1, -1, -1, -1};
        for (int axis = 0; axis < 3; ++axis) {
            touches &= (core::load4(q.low[axis]) <= core::splat4(p.high[axis][i]) + m_around) &
                       (core::load4(q.high[axis]) >= core::splat4(p.low[axis][i]) - m_around);
        }
        return core::laneBits(touches);
    }
    void openLeaf(const Node& p, std::uint32_t i, std::uint32_t node)
    {
        const Node& q = m_nodes[node];
        for (std::uint32_t lanes = touching(p, i, q); lanes != 0 && !m_isOver; lanes &= lanes - 1) {
            const auto j = static_cast<std::uint32_t>(std::countr_zero(lanes));
            if ((q.leafMask >> j & 1u) != 0) {
                call(p.child[i], q.child[j]);
            } else {
                openLeaf(p, i, q.child[j]);
            }
        }
    }
    void call(std::uint32_t leaf, std::uint32_t other)
    {
        m_isOver = !m_pair(m_thread, leaf >> 3, leaf & 7u, other >> 3, other & 7u);
    }

    const Node* m_nodes;
    core::Float4 m_around;
    unsigned m_thread;
    bool m_isOver = false;
    Pair& m_pair;
};

template<class Pair>
void BoxHierarchy::visitPairs(double around_mm, unsigned threads, Pair&& pair) const
{
    if (m_nodes.empty()) {
        return;
    }
    const auto around = static_cast<float>(1.000001 * around_mm);
    PairVisit visit(m_nodes.data(), around, 0, pair);
    if (threads < 2) {
        visit.openAll(0, 0);
        return;
    }
    // Enough pieces that both threads end at about the same time.
    constexpr std::size_t kPieces = 256;
    std::vector<std::array<std::uint32_t, 2>> pieces{{0, 0}};
    std::size_t opened = 0;
    for (; opened < pieces.size() && pieces.size() - opened < kPieces && !visit.isOver(); ++opened) {
        const auto [a, b] = pieces[opened];
        visit.open(a, b, [&pieces](std::uint32_t c, std::uint32_t d) { pieces.push_back({c, d}); });
    }
    if (visit.isOver()) {
        return;
    }
    std::atomic<std::size_t> next = opened;
    const auto work = [&](unsigned thread) {
        PairVisit mine(m_nodes.data(), around, thread, pair);
        for (std::size_t i = next++; i < pieces.size() && !mine.isOver(); i = next++) {
            mine.openAll(pieces[i][0], pieces[i][1]);
        }
    };
    std::future<void> other = std::async(std::launch::async, work, 1);
    work(0);
    other.get();
}

} // namespace palpate::geometry
