// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace palpate::geometry {

using core::Box;
using core::Vec3;

/// Three vertex indices, counter-clockwise seen from the side that the normal points to.
using Triangle = std::array<std::uint32_t, 3>;

/// Numbers that vary over a surface: one for each vertex, linear between, or one for each triangle.
struct MeshArray
{
    std::string name;
    bool isPerTriangle = false;
    std::vector<float> values; ///< NaN: not known there
};

/// The surface of one structure: shared vertices [mm] and triangles. A value type without invariants; what comes from a
/// file goes through `repair` before anything else relies on it.
struct TriangleMesh
{
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    std::vector<MeshArray> arrays{};

    /// @return the box of all vertices [mm], empty without any.
    [[nodiscard]] Box bounds() const;
};

/// Turns every triangle round, so that inside and outside change places.
void flip(TriangleMesh& mesh);

} // namespace palpate::geometry
