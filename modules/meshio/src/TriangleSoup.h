// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PreScan.h"

#include <palpate/geometry/TriangleMesh.h>

#include <vtkPolyData.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace palpate::meshio::internal {

/// All triangles of a file over shared vertices, each with its part.
struct TriangleSoup
{
    geometry::TriangleMesh mesh;                                   ///< in the file's own units and frame
    std::vector<std::uint32_t> part;                               ///< one a triangle; empty when all are part 0
    std::vector<std::string> partNames;                            ///< at least one
    std::vector<std::optional<std::array<double, 3>>> partColours; ///< as partNames, or empty
};

/// Turns polygons and strips into triangles, checking every index, and takes over parts and frame that VTK's arrays
/// say (VTP).
/// @param scan  gets notes, and the frame from field data
[[nodiscard]] core::Result<TriangleSoup> toTriangles(vtkPolyData& data, PreScan& scan, const ScanContext& context);

/// Cuts the soup into structures in O(n), converts to LPS and mm, and checks every coordinate.
[[nodiscard]] core::Result<std::vector<MeshStructure>> splitStructures(const TriangleSoup& soup, const PreScan& scan,
                                                                       const ScanContext& context,
                                                                       const std::string& fallbackName);

} // namespace palpate::meshio::internal
