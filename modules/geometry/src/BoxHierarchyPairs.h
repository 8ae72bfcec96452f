// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Definition of BoxHierarchy::visitPairs, for the sources that call it.

#include "palpate/geometry/BoxHierarchy.h"

#include <palpate/core/Float4.h>
#include <palpate/core/Parallel.h>

#include <array>
#include <bit>
#include <vector>

namespace palpate::geometry {

/// Traversal stack of node pairs and leaf-node pairs.
template<class Pair>
class alignas(64) PairVisit // one per thread, on separate cache lines
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

    /// Expands a pair of nodes, or a node with itself. @param next  called for node pairs to be expanded next
    template<class Next>
    void open(std::uint32_t a, std::uint32_t b, Next&& next)
    {
        const Node& p = m_nodes[a];
        const Node& q = m_nodes[b];
        for (std::uint32_t i = 0; i < 4; ++i) {
            if (p.low[0][i] > p.high[0][i]) {
                continue; // unused
            }
            // Expanding a node with itself visits each pair of children once.
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
    std::vector<PairVisit<std::remove_reference_t<Pair>>> visits; // one for each thread
    for (unsigned thread = 0; thread < std::max(1U, threads); ++thread) {
        visits.emplace_back(m_nodes.data(), around, thread, pair);
    }
    // Several pieces per thread for load balancing.
    const std::size_t most = 128 * visits.size();
    std::vector<std::array<std::uint32_t, 2>> pieces{{0, 0}};
    std::size_t opened = 0;
    for (; opened < pieces.size() && pieces.size() - opened < most && !visits[0].isOver(); ++opened) {
        const auto [a, b] = pieces[opened];
        visits[0].open(a, b, [&pieces](std::uint32_t c, std::uint32_t d) { pieces.push_back({c, d}); });
    }
    if (visits[0].isOver()) {
        return;
    }
    core::parallelFor(
        pieces.size() - opened,
        [&](std::size_t i, unsigned thread) {
            if (!visits[thread].isOver()) {
                visits[thread].openAll(pieces[opened + i][0], pieces[opened + i][1]);
            }
        },
        threads);
}

} // namespace palpate::geometry
