// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/meshio/MeshFile.h"
#include "palpate/meshio/SceneFile.h"
#include "palpate/meshio/ShapeSurface.h"

#include <palpate/core/Export.h>
#include <palpate/core/Message.h>
#include <palpate/geometry/Repair.h>

#include <memory>
#include <optional>
#include <string>

namespace palpate::meshio {

/// Variation of a tissue quantity over a surface, as used by the haptics.
struct SurfaceMap
{
    core::TissueMapping mapping;
    bool isPerTriangle = false;
    /// One value per vertex or triangle: scale, N/mm or N·s/mm; NaN: the structure's own value applies.
    std::vector<float> values;
};

/// A structure ready for display and haptics: repaired, flipped and posed in the world frame.
struct LoadedStructure
{
    SceneStructure description;            ///< with `part` set when the mesh file contains several structures
    std::string format;                    ///< of the mesh file, as MeshFile::format; empty: not from a file
    FileFrame frame = FileFrame::Untagged; ///< of the mesh file; the user's choice is in `description.frame`
    /// Surface for display and haptics in the world frame [mm], closed, turned and smoothed as described.
    std::shared_ptr<const geometry::RepairedMesh> surface;
    std::vector<SurfaceMap> maps{}; ///< at most one per quantity
    /// Stiffness ratio k/k0 at each vertex due to buried lumps [1], one list per haptics::kFeltPress_mm; empty: no
    /// effect. See study::applyBuriedLumps.
    std::vector<std::vector<float>> feltBelow{};
    bool isTransmitted =
        false; ///< a buried lump whose effect is transmitted through the organ; no contact with its own surface
    /// Surface before closing, turning and smoothing; equal to `surface` without either. Null: unknown, e.g. from a
    /// recording.
    std::shared_ptr<const geometry::RepairedMesh> asRead{};
    std::optional<geometry::Staircase> staircase{}; ///< found in `asRead`
    /// How `surface`, the rest shape, moves. Structures with equal descriptions share a motion. Null: it rests.
    std::shared_ptr<const geometry::SurfaceMotion> motion{};
    std::optional<HoleClosing> closing{};        ///< result of closing holes, when applied
    std::optional<SurfaceSmoothing> smoothing{}; ///< result of smoothing, when applied
    std::optional<SurfaceCurving> curving{};     ///< result of curving the facets, when applied
};

/// A scene with the meshes.
struct LoadedScene
{
    SceneFile scene; ///< one entry of `scene.structures` for each of `structures`
    std::vector<LoadedStructure> structures;
    std::vector<core::Message> warnings; ///< one line each for the user: repairs, assumed units, an untagged frame
    /// More likely unit of the mesh files [mm] when the assumed unit gives an organ less than 2 mm wide or a body of
    /// more than 5 m. Never applied; a scene file defines its own units.
    std::optional<double> likelyUnit_mm;
    std::vector<core::Message> losses;    ///< one line each: meshes of the scene that are missing, truncated or changed
    std::vector<SceneStructure> unopened; ///< structures that failed to open, kept for saving the scene
};

/// Opens a scene file, a mesh file, or a folder (all mesh files, sorted by name). Meshes without a scene file get
/// default tissue and colours by known anatomical names; all are visible and palpable, in layer 0. Files that fail to
/// open are reported as losses as long as any other file opens. A mesh that has changed since the scene was saved is
/// opened and also reported as a loss. A motion that cannot be made fails the whole scene.
/// @param options  `unit_mm` applies only to mesh files, because a scene file defines its own units; `frame` also
/// applies
///                 to structures of a scene without a frame.
[[nodiscard]] PALPATE_EXPORT core::Result<LoadedScene> loadScene(const std::filesystem::path& path,
                                                                 const ReadOptions& options = {});

/// Opens a scene in memory and reads the meshes again. @param path  name for messages
[[nodiscard]] PALPATE_EXPORT core::Result<LoadedScene> loadScene(SceneFile scene, const std::filesystem::path& path,
                                                                 const ReadOptions& options = {});

/// @return the default colour of a structure: by anatomical name, or else by number.
[[nodiscard]] PALPATE_EXPORT std::array<double, 3> defaultColour(const std::string& name, std::size_t number);

} // namespace palpate::meshio
