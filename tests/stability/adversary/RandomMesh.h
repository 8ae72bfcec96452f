// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Chance.h"

#include <palpate/geometry/TriangleMesh.h>

#include <string>
#include <vector>

namespace palpate::adversary {

using geometry::Triangle;
using geometry::TriangleMesh;

/// A mesh of about unit size, with what is known of it from how it was made.
struct RandomMesh
{
    std::string name;
    TriangleMesh mesh;
    /// Sets of triangles that each enclose a volume without a gap, normals outwards or (a cavity) inwards. A triangle
    /// is in one at most; what is in none is a sheet, a fin or loose.
    std::vector<std::vector<std::uint32_t>> bodies;
    /// Each body winds once around its inside and not at all around what is outside: none is a cavity or passes through
    /// itself.
    bool isSolid = true;
};

enum class MeshKind
{
    // Closed bodies.
    Box,
    BumpySphere,
    SpikySphere,
    ThinPlate,
    LShape,
    Notch,
    Slivers,
    Saddle,
    Overlapping,   ///< two bodies through each other
    Shells,        ///< a body with a cavity
    Tangle,        ///< a sphere that passes through itself
    Duplicates,    ///< some triangles twice, some of those turned round
    TouchingBoxes, ///< with a wall or a part of one in common
                   // Surfaces that have no inside, or parts without one.
    Fins,          ///< on a sphere
    Sheet,
    HoledSphere,
    TJunctions, ///< a box whose faces are cut differently
    Soup,       ///< loose triangles
};
constexpr int kClosedKinds = 13, kMeshKinds = 18;

[[nodiscard]] RandomMesh randomMesh(MeshKind kind, Chance& chance);

} // namespace palpate::adversary
