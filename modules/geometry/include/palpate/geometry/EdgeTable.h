// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/TriangleMesh.h"

#include <palpate/core/Export.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate::geometry {

/// Use of an edge by a triangle.
struct EdgeUse
{
    std::uint32_t other;    ///< the larger vertex index of the edge; uses are grouped by the smaller index
    std::uint32_t triangle; ///< triangle that contains the edge
    bool isForward;         ///< traversed from the smaller to the larger vertex
};

/// Edge-to-triangle adjacency of a mesh, built in O(n log n) time and O(n) memory, read-only afterwards. An edge may
/// belong to any number of triangles.
class PALPATE_EXPORT EdgeTable
{
  public:
    /// @pre every index of `mesh` is in range
    explicit EdgeTable(const TriangleMesh& mesh);

    /// Calls `edge(const EdgeUse* uses, std::size_t count)` for every edge, with the triangles in ascending order.
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
    std::vector<std::uint32_t> m_first; ///< start of the uses, indexed by the smaller vertex
    std::vector<EdgeUse> m_uses;
};

} // namespace palpate::geometry
