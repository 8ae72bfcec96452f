// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/FileFrame.h>
#include <palpate/core/Message.h>
#include <palpate/core/Status.h>
#include <palpate/geometry/Staircase.h>
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
    std::optional<std::array<double, 3>> colour; ///< red, green, blue in 0 … 1, if present in the file
    double opacity = 1.0;                        ///< 0 … 1, from the materials of an OBJ
};

/// Content of a mesh file, in LPS and mm. Every index is in range and every coordinate finite and within 1e7 mm; each
/// structure has at least one triangle.
struct MeshFile
{
    std::filesystem::path path;
    std::string format; ///< "STL binary", "STL ASCII", else the name in MeshFormats.h
    FileFrame frame =
        FileFrame::Untagged; ///< from the tag `SPACE=`, the header or the format, regardless of the options
    double unit_mm = 1.0;    ///< assumed size of one file unit [mm]
    std::vector<MeshStructure> structures;
    std::vector<core::Message> notes; ///< ignored or assumed content, one sentence per entry
    /// Voxels of a label map, whose surfaces are staircases of them; empty for a mesh.
    std::optional<geometry::Staircase> voxels{};
    core::Message loss; ///< missing part of a truncated file, one line with counts; see `isPartial`
};

struct LoadedStructure;

struct ReadOptions
{
    double unit_mm = 1.0; ///< size of one unit of the file [mm]: 1000 for metres, 10 for cm
    /// Progress callback (0 to 1). Return false to cancel. Called on the reading thread. May be empty.
    std::function<bool(double)> progress;
    /// Reads the complete elements of a truncated STL, OBJ or PLY instead of refusing the file, and reports the missing
    /// part in `loss`. A truncated VTP or VTK is always refused.
    bool isPartial = false;
    /// Axes of the coordinates, overriding the tag of the file; Untagged: by the tag, otherwise LPS.
    FileFrame frame = FileFrame::Untagged;
    /// Uses the unit from 3D Slicer's `SCALE=` in an STL header, if present and `unit_mm` is 1.
    bool readsScale = true;
    /// Options of `loadScene` for every structure, overriding the scene: turn inverted closed parts, close holes,
    /// smooth the surface (SurfaceKind::Smoothed) and curve the facets (SurfaceKind::Smooth).
    bool turnsOutwards = false;
    double closeHoles_mm = 0.0; ///< close holes up to this size; 0: as in the scene [mm]
    bool isSmoothed = false;
    bool isCurved = false;
    /// Option of `loadScene`: strength of the smoothing of each smoothed surface, as of label maps, 0 … 1; overrides
    /// the scene. 0 keeps the voxel steps. Empty: as in the scene, or as `defaultSmoothing`.
    std::optional<double> smoothing{};
    /// Receives structures of a label map while the child process makes the next ones (startImportServer; without it,
    /// and for other formats, not called). The last of `file.structures` is the new one, and `file` has format, frame,
    /// unit and voxels. The callback may take the mesh of the new structure. Structures are in the order of the file;
    /// those that are complete when the child ends are only in the result. If reading fails or is cancelled, the
    /// received structures are void. Called on the reading thread. May be empty.
    std::function<void(MeshFile& file)> structureRead{};
    /// Option of `loadScene`: receives each structure as soon as its surface is ready, for a preview: description and
    /// `surface`. Names and colours may still change, and all are void if loading fails or is cancelled.
    /// Called on any thread, and on several at a time. May be empty.
    std::function<void(const LoadedStructure& structure)> structureReady{};
};

/// Reads a mesh file in a format of MeshFormats.h, detected from the content.
///
/// Triangulates polygons and strips. STL solids, OBJ objects, groups or materials, and the `StructureId` cell array
/// with `StructureNames` of a VTP, become structures, with names that differ and are valid UTF-8. Independent of the
/// numeric locale.
/// @return on failure one line with the file, the place, the found and the expected value
/// @par Thread Any; no shared state.
[[nodiscard]] PALPATE_EXPORT core::Result<MeshFile> readMesh(const std::filesystem::path& path,
                                                             const ReadOptions& options = {});

/// Writes VTP (with `StructureId`, `StructureNames` and `SPACE=LPS`) or binary STL (structures merged, `SPACE=LPS` in
/// the header), by the extension. Atomic: writes a temporary file in the same folder, then renames.
[[nodiscard]] PALPATE_EXPORT core::Status writeMesh(const std::filesystem::path& path,
                                                    std::span<const MeshStructure> structures);

} // namespace palpate::meshio
