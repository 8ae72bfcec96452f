// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/MeshReport.h"
#include "palpate/geometry/TriangleMesh.h"

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>

#include <cstdint>
#include <vector>

namespace palpate::geometry {

/// Marks an input vertex without a vertex in the repaired mesh: no triangle that was kept uses it.
inline constexpr std::uint32_t kNoVertex = 0xffffffffU;

/// Mesh that fulfils the preconditions of SurfaceIndex: all indices in range, no duplicate vertices, no zero-area or
/// duplicate triangles, and a consistent orientation of each orientable component.
struct RepairedMesh
{
    TriangleMesh mesh;
    /// For each triangle: 1 if the component is open, so that contact is possible from both sides.
    std::vector<std::uint8_t> twoSided;
    /// For each triangle: index in the input mesh. The corners keep their input order, so values at corners carry over
    /// directly, except where `turned` is set.
    std::vector<std::uint32_t> source;
    /// For each triangle: 1 if reversed, i.e. the second and third corner are swapped. Empty if no triangle is
    /// reversed.
    std::vector<std::uint8_t> turned;
    MeshReport report;
    /// For each vertex: index in the input mesh, the lowest of the welded ones, or kNoVertex for a vertex that a
    /// subdivision added. Like `vertexOfSource` empty in a
    /// surface read from a recording.
    std::vector<std::uint32_t> vertexSource{};
    /// For each input vertex: index in `mesh`, or kNoVertex. Carries values at the vertices of `mesh` back to all input
    /// vertices.
    std::vector<std::uint32_t> vertexOfSource{};
};

/// Orientation of closed surfaces after repair.
enum class Facing : std::uint8_t
{
    /// A consistently oriented component keeps its orientation. Contact is from the front only, so a closed surface
    /// with inward normals is felt from within and not from outside.
    AsGiven,
    /// Turns closed outermost components outwards, together with all closed components inside them, whose cavities
    /// remain cavities. vtkMarchingCubes, for example, gives inward normals for a signed distance.
    Outward
};

struct RepairOptions
{
    Facing facing = Facing::Outward;
    /// Largest distance of a vertex to the vertex that it is welded to [mm], at least 0. 0: equal coordinates only. Use
    /// the rounding error of a computed mesh, for example 1e-6, and much less than the shortest edge: triangles that
    /// lose their area are removed.
    double weldWithin_mm = 0.0;
};

/// Repairs one structure's mesh for haptic rendering and reports the changes.
///
/// Arrays are carried over: a welded vertex gets the mean of the known values.
///
/// Welds vertices, removes zero-area and duplicate triangles, and orients each component. An inconsistent but
/// orientable component is made consistent (outwards if closed), a consistent one is oriented as requested. A component
/// is closed if every edge is traversed equally often in both directions.
/// @pre `check(mesh)` finds no error
/// @par Cost O(n log n). Any thread.
[[nodiscard]] PALPATE_EXPORT RepairedMesh repair(const TriangleMesh& mesh, const RepairOptions& options);
/// As above, without welding by distance. Meshes from files keep their facing; for meshes from memory see `surfaceOf`.
[[nodiscard]] inline RepairedMesh repair(const TriangleMesh& mesh, Facing facing = Facing::AsGiven)
{
    return repair(mesh, RepairOptions{.facing = facing});
}

/// Checks and repairs a mesh from memory, for example of a reconstruction.
///
///     const auto liver = geometry::surfaceOf(mesh);
///     if (!liver.isOk()) {
///         return liver.status();
///     }
///     for (const core::Message& sentence : liver.value().report.sentences()) {
///         std::puts(sentence.english().c_str());
///     }
///
/// @return the error of `check`; OutOfRange for an invalid weldWithin_mm; Empty if no triangle has an area
/// @par Cost As `repair`. Any thread.
[[nodiscard]] PALPATE_EXPORT core::Result<RepairedMesh> surfaceOf(const TriangleMesh& mesh,
                                                                  const RepairOptions& options = {});

} // namespace palpate::geometry
