// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/FileFrame.h>
#include <palpate/core/Status.h>
#include <palpate/geometry/TriangleMesh.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace palpate::meshio {

using core::FileFrame;

/// One structure of a file, in LPS and mm.
struct MeshStructure
{
    std::string name; ///< from the file, else the file's stem
    geometry::TriangleMesh mesh;
    std::optional<std::array<double, 3>> colour; ///< red, green, blue in 0 … 1, where the file has one
};

/// All of a mesh file, in LPS and mm. Every index is in range and every coordinate finite and within 1e7 mm; each
/// structure has at least one triangle.
struct MeshFile
{
    std::filesystem::path path;
    std::string format;                    ///< "STL binary", "STL ASCII", else the name in MeshFormats.h
    FileFrame frame = FileFrame::Untagged; ///< its tag (`SPACE=` of 3D Slicer), whatever was asked for
    double unit_mm = 1.0;                  ///< what one unit of the file was taken as [mm]
    std::vector<MeshStructure> structures;
    std::vector<std::string> notes; ///< what was ignored or assumed, one sentence an entry
    std::string loss;               ///< what a file that was cut off has lost, one line with its count; see `isPartial`
};

struct ReadOptions
{
    double unit_mm = 1.0; ///< what one unit of the file's numbers is [mm]: 1000 for metres, 10 for cm
    /// Told the share done, 0 … 1; return false to cancel. Called on the reading thread. May be empty.
    std::function<bool(double)> progress;
    /// Reads what is whole of an STL, OBJ or PLY that was cut off, instead of refusing it, and says in `loss` what is
    /// not there. A VTP or VTK that was cut off is refused all the same.
    bool isPartial = false;
    /// The axes that the coordinates are along, whatever the file's tag says; Untagged: as the tag says, else LPS.
    FileFrame frame = FileFrame::Untagged;
    /// Takes the unit from 3D Slicer's `SCALE=` in an STL header, where there is one and `unit_mm` is 1.
    bool readsScale = true;
    /// What `loadScene` does to every structure, whatever its scene says: turn closed parts that are inside out, and
    /// smooth the surface (SurfaceKind::Smoothed).
    bool turnsOutwards = false;
    bool isSmoothed = false;
};

/// Reads a mesh file of one of the formats of MeshFormats.h; which one is told from the content.
///
/// Polygons and strips are triangulated. OBJ groups and objects, and the `StructureId` cell array with
/// `StructureNames` of a VTP, become structures. The numeric locale does not matter.
/// @return one line that names the file, the place, what was found and what was expected, if it cannot be read whole
/// @par Thread Any; no shared state.
[[nodiscard]] core::Result<MeshFile> readMesh(const std::filesystem::path& path, const ReadOptions& options = {});

/// Writes VTP (with `StructureId`, `StructureNames` and `SPACE=LPS`) or binary STL (structures merged, `SPACE=LPS` in
/// the header), by the extension. Atomic: a temporary file beside it, then a rename.
[[nodiscard]] core::Status writeMesh(const std::filesystem::path& path, std::span<const MeshStructure> structures);

} // namespace palpate::meshio
