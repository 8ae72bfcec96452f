// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Chance.h"

#include <palpate/geometry/TriangleMesh.h>

#include <string>
#include <vector>

namespace palpate::adversary {

using geometry::Triangle;
using geometry::TriangleMesh;

/// A mesh of about unit size, with properties known from its construction.
struct RandomMesh
{
    std::string name;
    TriangleMesh mesh;
    /// Sets of triangles that each enclose a volume without a gap, with normals outwards or (for a cavity) inwards. A
    /// triangle is in at most one set; all others belong to a sheet, a fin or are loose.
    std::vector<std::vector<std::uint32_t>> bodies;
    /// True if each body winds once around its inside and zero times around the outside: no cavities and no
    /// self-intersections.
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
    Overlapping,   ///< two intersecting bodies
    Shells,        ///< a body with a cavity
    Tangle,        ///< a self-intersecting sphere
    Duplicates,    ///< duplicated triangles, some of them reversed
    TouchingBoxes, ///< with a wall or a part of one in common
                   // Surfaces that have no inside, or parts without one.
    Fins,          ///< attached to a sphere
    Sheet,
    HoledSphere,
    TJunctions, ///< a box with faces that are subdivided differently
    Soup,       ///< loose triangles
};
constexpr int kClosedKinds = 13, kMeshKinds = 18;

[[nodiscard]] RandomMesh randomMesh(MeshKind kind, Chance& chance);

} // namespace palpate::adversary
