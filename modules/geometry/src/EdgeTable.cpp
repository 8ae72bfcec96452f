// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/EdgeTable.h"

#include <algorithm>
#include <numeric>

namespace palpate::geometry {

EdgeTable::EdgeTable(const TriangleMesh& mesh)
    : m_first(mesh.vertices.size() + 1, 0)
    , m_uses(3 * mesh.triangles.size())
{
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            ++m_first[std::min(t[k], t[(k + 1) % 3]) + 1];
        }
    }
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    std::vector<std::uint32_t> next(m_first.begin(), m_first.end() - 1);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            m_uses[next[std::min(a, b)]++] = {std::max(a, b), static_cast<std::uint32_t>(i), a < b};
        }
    }
    for (std::size_t v = 0; v + 1 < m_first.size(); ++v) {
        std::sort(m_uses.begin() + m_first[v], m_uses.begin() + m_first[v + 1], [](const EdgeUse& x, const EdgeUse& y) {
            return x.other != y.other ? x.other < y.other : x.triangle < y.triangle;
        });
    }
}

} // namespace palpate::geometry
