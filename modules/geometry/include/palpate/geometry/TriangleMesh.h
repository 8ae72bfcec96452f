// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Types.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace palpate::geometry {

using core::Box;
using core::Vec3;

/// Three vertex indices, counter-clockwise seen from the side of the normal.
using Triangle = std::array<std::uint32_t, 3>;

/// Scalar field on a surface: one value for each vertex, interpolated linearly, or one for each triangle.
struct MeshArray
{
    std::string name;
    bool isPerTriangle = false;
    std::vector<float> values; ///< NaN: unknown
};

/// Surface of one structure: shared vertices [mm] and triangles. A value type without invariants; meshes from files
/// must pass `repair` before further use.
struct PALPATE_EXPORT TriangleMesh
{
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    std::vector<MeshArray> arrays{};

    /// @return bounding box of all vertices [mm]; empty without vertices.
    [[nodiscard]] Box bounds() const;
};

/// Reverses the winding of every triangle, swapping inside and outside.
PALPATE_EXPORT void flip(TriangleMesh& mesh);

} // namespace palpate::geometry
