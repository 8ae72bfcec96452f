// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/TriangleMesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate::geometry {

/// One use of an edge by a triangle.
struct EdgeUse
{
    std::uint32_t other;    ///< the edge's larger vertex; uses are grouped by the smaller one
    std::uint32_t triangle; ///< that has the edge
    bool isForward;         ///< traversed from the smaller to the larger vertex
};

/// The triangles at every edge of a mesh, in O(n) memory and O(n log n) time. Read-only once
/// built. Any number of triangles may share an edge.
class EdgeTable
{
  public:
    /// @pre every index of `mesh` is in range
    explicit EdgeTable(const TriangleMesh& mesh);

    /// Calls `edge(const EdgeUse* uses, std::size_t count)` for every edge, its triangles in ascending order.
    template<class F>
    void forEach(F&& edge) const
    {
        for (std::size_t v = 0; v + 1 < m_first.size(); ++v) {
            for (std::uint32_t i = m_first[v]; i < m_first[v + 1];) {
                std::uint32_t end = i + 1;
                while (end < m_first[v + 1] && m_uses[end].other == m_uses[i].other) {
                    ++end;
                }
                edge(&m_uses[i], static_cast<std::size_t>(end - i));
                i = end;
            }
        }
    }

  private:
    std::vector<std::uint32_t> m_first; ///< by smaller vertex, where its uses begin
    std::vector<EdgeUse> m_uses;
};

} // namespace palpate::geometry
