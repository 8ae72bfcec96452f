// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "guard/PreScan.h"
#include "guard/TriangleSoup.h"

#include <vtkPolyData.h>

#include <string>
#include <vector>

namespace palpate::meshio::internal {

/// Converts polygons and strips to triangles, checks every index, and applies parts and frame from VTK's arrays (VTP).
/// @param scan  receives notes, and the frame from field data
[[nodiscard]] core::Result<TriangleSoup> toTriangles(vtkPolyData& data, PreScan& scan, const ScanContext& context);

/// Splits the soup into structures in O(n), converts to LPS and mm, and checks every coordinate.
/// Names become valid UTF-8 and different from each other.
/// @param scan  receives notes
[[nodiscard]] core::Result<std::vector<MeshStructure>>
splitStructures(const TriangleSoup& soup, PreScan& scan, const ScanContext& context, const std::string& fallbackName);

} // namespace palpate::meshio::internal
