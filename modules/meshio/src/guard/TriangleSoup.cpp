// SPDX-License-Identifier: BSD-3-Clause
#include "guard/TriangleSoup.h"

namespace palpate::meshio::internal {

void TriangleSoup::add(const geometry::TriangleMesh& more, const std::string& name,
                       const std::optional<std::array<double, 3>>& colour)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
    for (const geometry::Triangle& t : more.triangles) {
        mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    part.resize(mesh.triangles.size(), static_cast<std::uint32_t>(partNames.size()));
    partNames.push_back(name);
    partColours.push_back(colour);
}

} // namespace palpate::meshio::internal
