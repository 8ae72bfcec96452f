// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/Holes.h"

#include "palpate/geometry/EdgeTable.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

namespace palpate::geometry {

std::vector<Hole> holesOf(const TriangleMesh& mesh)
{
    std::vector<std::uint32_t> in(mesh.vertices.size()); // union of the vertices of each hole
    std::iota(in.begin(), in.end(), 0U);
    const auto rootOf = [&in](std::uint32_t v) {
        while (in[v] != v) {
            v = in[v] = in[in[v]];
        }
        return v;
    };
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    EdgeTable(mesh).forEach([&](const EdgeUse* uses, std::size_t count) {
        if (count == 1) {
            const Triangle& t = mesh.triangles[uses->triangle];
            const std::uint32_t other = uses->other;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = t[k], b = t[(k + 1) % 3];
                if (std::max(a, b) == other && (a < b) == uses->isForward) {
                    edges.emplace_back(a, b);
                    in[rootOf(a)] = rootOf(b);
                    break;
                }
            }
        }
    });
    std::map<std::uint32_t, std::pair<std::size_t, Box>> found;
    for (const auto& [a, b] : edges) {
        auto& [count, box] = found[rootOf(a)];
        ++count;
        box.extend(mesh.vertices[a]);
        box.extend(mesh.vertices[b]);
    }
    std::vector<Hole> holes;
    for (const auto& [root, hole] : found) {
        holes.push_back({hole.first, hole.second.diagonal().norm()});
    }
    std::sort(holes.begin(), holes.end(), [](const Hole& a, const Hole& b) { return a.across_mm > b.across_mm; });
    return holes;
}

} // namespace palpate::geometry
