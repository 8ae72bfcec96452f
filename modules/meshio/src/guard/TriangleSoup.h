// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/TriangleMesh.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace palpate::meshio::internal {

/// All triangles of a file with shared vertices and the part of each triangle.
struct TriangleSoup
{
    geometry::TriangleMesh mesh;                                   ///< in the file's own units and frame
    std::vector<std::uint32_t> part;                               ///< one per triangle; empty when all are part 0
    std::vector<std::string> partNames;                            ///< at least one
    std::vector<std::optional<std::array<double, 3>>> partColours; ///< as partNames, or empty
    std::vector<double> partOpacities;                             ///< as partNames, or empty
};

} // namespace palpate::meshio::internal
