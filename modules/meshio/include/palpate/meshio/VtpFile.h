// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>
#include <palpate/core/Types.h>
#include <palpate/geometry/TriangleMesh.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace palpate::meshio {

/// Named point or cell values: numbers, vectors or integers.
struct VtpArray
{
    std::string name;
    std::variant<std::vector<double>, std::vector<core::Vec3>, std::vector<std::int32_t>> values;
};

/// Content of a VTP file beyond plain structures (for plain structures see `writeMesh`). LPS, mm.
struct VtpFile
{
    std::vector<core::Vec3> points;
    /// End index of each line in `points`, ascending; the next line starts there. A line of one point is written as a
    /// vertex; an empty line is skipped.
    std::vector<std::size_t> lineEnds;
    std::vector<geometry::Triangle> triangles;
    std::vector<VtpArray> pointArrays;        ///< one value per point; viewers display the first array
    std::vector<VtpArray> cellArrays;         ///< one value per triangle; only without lines
    std::vector<std::string> structureNames;  ///< field array `StructureNames`, omitted when empty
    std::vector<core::Vec3> structureColours; ///< field array `StructureColours` (RGB, 0 to 1), omitted when empty
};

/// @return the bytes of the file, tagged `SPACE=LPS`; Internal with the VTK message on failure
/// @pre every index is below the number of points, and every array has the matching length
[[nodiscard]] PALPATE_EXPORT core::Result<std::string> vtpBytes(const VtpFile& content);

} // namespace palpate::meshio
