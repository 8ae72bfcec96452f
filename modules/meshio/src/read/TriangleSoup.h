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

/// Splits the soup into structures in O(n), converts to LPS and mm, and checks every coordinate. Names become valid
/// UTF-8.
/// @param scan  receives notes
[[nodiscard]] core::Result<std::vector<MeshStructure>> separate(const TriangleSoup& soup, PreScan& scan,
                                                                const ScanContext& context);

/// Same for a whole file: replaces names that programs write for unnamed parts, and makes all names different.
/// @param fallbackName  for unnamed parts
[[nodiscard]] core::Result<std::vector<MeshStructure>>
splitStructures(const TriangleSoup& soup, PreScan& scan, const ScanContext& context, const std::string& fallbackName);

} // namespace palpate::meshio::internal
