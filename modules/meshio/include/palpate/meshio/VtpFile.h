// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>
#include <palpate/core/Types.h>
#include <palpate/geometry/TriangleMesh.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace palpate::meshio {

/// Values of points or cells under a name: numbers, vectors or whole numbers.
struct VtpArray
{
    std::string name;
    std::variant<std::vector<double>, std::vector<core::Vec3>, std::vector<std::int32_t>> values;
};

/// What goes into a VTP file besides plain structures (those: `writeMesh`). LPS, mm.
struct VtpFile
{
    std::vector<core::Vec3> points;
    /// Lines through the points in their order: where each ends and the next begins, ascending. A line of one point is
    /// written as a vertex, one of none is left out.
    std::vector<std::size_t> lineEnds;
    std::vector<geometry::Triangle> triangles;
    std::vector<VtpArray> pointArrays;        ///< one value a point each; the first is what a viewer shows
    std::vector<VtpArray> cellArrays;         ///< one value a triangle each; only where there are no lines
    std::vector<std::string> structureNames;  ///< field array `StructureNames`, where there are some
    std::vector<core::Vec3> structureColours; ///< field array `StructureColours`, likewise: red, green, blue in 0 … 1
};

/// @return the bytes of the file, tagged `SPACE=LPS`; Internal with what VTK says when it cannot
/// @pre every index is below the number of points, and arrays have the length that they should
[[nodiscard]] core::Result<std::string> vtpBytes(const VtpFile& content);

} // namespace palpate::meshio
