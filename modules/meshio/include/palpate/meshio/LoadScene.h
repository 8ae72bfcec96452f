// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/meshio/MeshFile.h"
#include "palpate/meshio/SceneFile.h"
#include "palpate/meshio/ShapeSurface.h"

#include <palpate/geometry/MeshReport.h>

#include <memory>
#include <optional>

namespace palpate::meshio {

/// How a quantity varies over a surface, as it is felt.
struct SurfaceMap
{
    core::TissueMapping mapping;
    bool isPerTriangle = false;
    /// One for each vertex or triangle of the surface, scale, N/mm or N·s/mm; NaN: the structure's own is felt there.
    std::vector<float> values;
};

/// One structure ready for the view and for touching: repaired, flipped and posed in the world frame.
struct LoadedStructure
{
    SceneStructure description;            ///< its `part` is filled where the mesh file holds several
    FileFrame frame = FileFrame::Untagged; ///< the mesh file's tag; `description.frame` is what was chosen for it
    /// World frame [mm]: as it is drawn and felt, turned and smoothed where the description says so.
    std::shared_ptr<const geometry::RepairedMesh> surface;
    std::vector<SurfaceMap> maps{}; ///< at most one for each quantity
    /// What lumps below make of the stiffness felt, k/k0 at each vertex [1], one list for each of
    /// haptics::kFeltPress_mm; empty: nothing. See study::feelBuried.
    std::vector<std::vector<float>> feltBelow{};
    bool isFeltThrough = false; ///< a lump that is felt through its organ: its own surface is not touched
    /// The surface before it was turned and smoothed; `surface` itself where it was neither. Null: unknown, as of a
    /// surface that a recording holds.
    std::shared_ptr<const geometry::RepairedMesh> asRead{};
    std::optional<geometry::Staircase> staircase{}; ///< found in `asRead`
    std::optional<SurfaceSmoothing> smoothing{};    ///< what smoothing did, where it did something
};

/// A scene with its meshes.
struct LoadedScene
{
    SceneFile scene; ///< one entry of `scene.structures` for each of `structures`
    std::vector<LoadedStructure> structures;
    std::vector<std::string> warnings; ///< one line each, for a person: repairs, assumed units, an untagged frame
    /// What one unit of the mesh files more likely is [mm], when that is not what it was taken for: an organ less than
    /// 2 mm wide, or a body of more than 5 m. Never applied; a scene file says its own units.
    std::optional<double> likelyUnit_mm;
    std::vector<std::string>
        losses; ///< one line each: what the scene names but is missing, cut off, or another one now
    std::vector<SceneStructure> unopened; ///< what could not be opened, to be kept when the scene is saved
};

/// Opens a scene file, a mesh file, or a folder (all its mesh files, sorted by name). Meshes without a scene file get
/// default tissue and colours by known anatomical names; all is visible and palpable, in layer 0. What cannot be opened
/// is a loss while anything else can; a mesh that has changed since the scene was saved is one too, and is opened.
/// @param options  `unit_mm` holds for mesh files only: a scene file says its own. So does `frame`, but for structures
///                 of a scene that say none.
[[nodiscard]] core::Result<LoadedScene> loadScene(const std::filesystem::path& path, const ReadOptions& options = {});

/// Opens a scene that is in memory: the meshes are read again. @param path  what messages name
[[nodiscard]] core::Result<LoadedScene> loadScene(SceneFile scene, const std::filesystem::path& path,
                                                  const ReadOptions& options = {});

/// @return the colour of a structure where nothing says it: by its anatomical name, else by its number.
[[nodiscard]] std::array<double, 3> usualColour(const std::string& name, std::size_t number);

} // namespace palpate::meshio
