// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/study/LumpRule.h"

#include <palpate/core/Export.h>
#include <palpate/core/Message.h>
#include <palpate/geometry/SurfaceIndex.h>
#include <palpate/geometry/SurfaceMotion.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/meshio/LoadScene.h>
#include <palpate/session/Recording.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate::study {

/// Name of a hidden target of an exercise in `OpenStructure`. See OpenScene::described.
inline constexpr const char* kUnnamed = "unnamed structure";

/// Structure of the open scene: loaded data, current description and derived data.
struct OpenStructure
{
    meshio::LoadedStructure loaded;                      ///< `loaded.description` is edited
    std::shared_ptr<const geometry::SurfaceIndex> touch; ///< haptic copy; null until palpable and built
    std::string sha256;                                  ///< geometryHash, available together with `touch`
    std::optional<std::size_t> in{};                     ///< smallest structure around this one
    haptics::TissueMaps felt{}; ///< `loaded.maps` prepared for the servo tick, available together with `touch`
    std::vector<core::Message> mapProblems{}; ///< reasons for unavailable maps, one sentence each
    /// `loaded.feltBelow` from a recording. Used while buried lumps are separate layers; never recomputed.
    std::vector<std::vector<float>> recordedBelow{};
    /// Removed from the scene: not drawn, palpable, listed or saved. The structure keeps its number for recordings,
    /// undo steps and the view, and returns with undo.
    bool isRemoved = false;

    /// Returns true if the structure is in the scene and may be shown and named: not a hidden target of an exercise.
    [[nodiscard]] bool isListed() const noexcept { return !isRemoved && !loaded.description.isHiddenTarget; }
    /// Returns true if the structure is in the scene and has triangles.
    [[nodiscard]] bool isThere() const noexcept
    {
        return !isRemoved && loaded.surface != nullptr && !loaded.surface->mesh.triangles.empty();
    }
};

/// A change of the open scene as a value: new descriptions, removed and restored structures.
struct SceneEdit
{
    struct Description
    {
        std::size_t structure = 0;
        meshio::SceneStructure description;
    };
    std::vector<Description> descriptions;
    std::optional<meshio::BuriedTouch> buried; ///< empty: unchanged
    std::vector<std::size_t> removed, restored;
};

/// One consequence of a change, for those who show or feel the scene.
struct SceneEvent
{
    enum class Kind : std::uint8_t
    {
        MapsWanted,    ///< volumes must be read for the maps; `setMaps` delivers the result
        SurfaceWanted, ///< the surface must be built again from `loaded.asRead`; `setSurface` delivers the result
        Renamed,       ///< `before` is the old name
        Look,          ///< colour, opacity or visibility
        Touch          ///< everything that the haptic scene contains
    };
    Kind kind = Kind::Look;
    std::size_t structure = 0;
    std::string before{};
};
using SceneEvents = std::vector<SceneEvent>; ///< in the order of occurrence

/// Returns true if different surfaces must be built from the same mesh.
[[nodiscard]] PALPATE_EXPORT bool needsOtherSurface(const meshio::SceneStructure& a,
                                                    const meshio::SceneStructure& b) noexcept;

/// The open scene: structures, layers, lumps and maps. Edits are values, so that an undo step holds an edit and its
/// inverse:
///
///     const SceneEdit undo = scene.inverse(edit);
///     announce(scene.apply(edit));
///
/// Structures keep their numbers. View, hand, panels and files read from here.
///
/// Targets of an exercise can be hidden. What is displayed comes from `structures()`, where a hidden target is neither
/// drawn nor listed and has the name kUnnamed: code that names a structure cannot give a target away. What is felt,
/// recorded, computed and saved uses `described`.
/// @par Thread One thread at a time; the window's.
class PALPATE_EXPORT OpenScene
{
  public:
    /// Replaces all structures. @param exercise  of these structures
    void reset(std::vector<OpenStructure> structures, meshio::BuriedTouch buried,
               std::optional<meshio::Exercise> exercise = {});
    [[nodiscard]] const std::vector<OpenStructure>& structures() const noexcept { return m_structures; }
    /// Touch mode of structures inside organs.
    [[nodiscard]] meshio::BuriedTouch buried() const noexcept { return m_buried; }

    /// Exercise of the scene; empty: none.
    [[nodiscard]] const std::optional<meshio::Exercise>& exercise() const noexcept { return m_exercise; }
    /// Hides the targets of the exercise, which are felt all the same, or shows them. Not an edit, so that no undo step
    /// can reveal a target.
    SceneEvents setTargetsHidden(bool areHidden);
    /// Returns the number of hidden targets.
    [[nodiscard]] std::size_t hiddenTargets() const noexcept;
    /// Returns the description with the name of a hidden target. For files, recordings and computations, never for
    /// display. The reference is valid until the next change.
    [[nodiscard]] const meshio::SceneStructure& described(std::size_t structure) const;
    /// Returns true if a text for display contains the name, or the name of the mesh file, of a hidden target. For
    /// texts that were composed before the target was hidden. Ignores case and prefixes that the window does not
    /// display, such as "VH_F_", and reads "_" as a space.
    [[nodiscard]] bool givesTargetAway(const std::string& text) const;

    /// Applies an edit. Targets stay hidden or shown as they are, hidden targets keep their names, and the exercise
    /// follows new names.
    SceneEvents apply(const SceneEdit& edit);
    /// Returns the edit that takes back `edit`. Call it before `apply`.
    [[nodiscard]] SceneEdit inverse(const SceneEdit& edit) const;
    /// Appends a structure, which is absent until an edit restores it. @return its number
    std::size_t append(OpenStructure structure);

    /// Effect of an organ's lumps on the organ's surface: for each haptics::kFeltPress_mm one number per vertex.
    struct TransmittedMap
    {
        std::size_t organ = 0;
        std::vector<std::size_t> lumps;
        std::vector<std::vector<float>> below; ///< k/k0 [1]
    };
    /// Replaces the maps of all organs. Not an edit.
    SceneEvents setTransmittedMaps(const std::vector<TransmittedMap>& maps);
    /// Sets the surrounding structures after a containment test.
    void setNesting(const std::vector<std::optional<std::size_t>>& in);
    /// Sets a structure's haptic copy; null removes the copy.
    void setTouch(std::size_t structure, std::shared_ptr<const geometry::SurfaceIndex> touch, std::string sha256);
    /// Sets how a structure moves, for a change of pace. Not an edit: the description stays.
    void setMotion(std::size_t structure, std::shared_ptr<const geometry::SurfaceMotion> motion);
    /// Takes the maps computed by `meshio::resolveMaps`.
    /// @param of  mappings used for the computation
    /// @return false if the mappings have changed since; nothing is taken
    bool setMaps(std::size_t structure, const std::optional<std::vector<core::TissueMapping>>& of,
                 std::vector<meshio::SurfaceMap> maps, std::vector<core::Message> problems);
    /// Takes a surface built from `loaded.asRead` with all derived data.
    /// @return nothing if the description has changed since; otherwise the events
    std::optional<SceneEvents> setSurface(std::size_t structure, const OpenStructure& built);

    /// Returns the rule for lumps and organs. It refers to this scene until the next change.
    [[nodiscard]] LumpRule lumpRule() const;
    /// Returns true for a lump in transmitted mode, felt through its organ (see applyBuriedLumps). Until the map is
    /// computed, `loaded.isTransmitted` is false and the lump is a separate layer.
    [[nodiscard]] bool isTransmitted(std::size_t structure) const;
    /// Returns isTransmitted for all structures, with one evaluation of the rule.
    [[nodiscard]] std::vector<bool> transmitted() const;

    /// Returns the structures with parameters limited by the device's total stiffness (see DeviceLimit.h).
    [[nodiscard]] std::vector<haptics::HapticStructure> hapticStructures(const haptics::Tissue& limit) const;
    /// Returns the haptic scene. @param fingertip_mm  radius of the probe sphere, 0: a point
    [[nodiscard]] std::shared_ptr<const haptics::HapticScene> hapticScene(const haptics::Tissue& limit,
                                                                          double fingertip_mm) const;
    /// Returns the sources of the surfaces for a recording, including the geometry of palpable structures.
    [[nodiscard]] std::vector<session::StructureSource> sources() const;
    /// Returns the scene as it would be loaded, for computations on other threads. Removed structures keep their place
    /// without a surface.
    [[nodiscard]] meshio::LoadedScene loadedScene() const;
    /// Adds buried mode, exercise and structures to the rest of a scene file.
    [[nodiscard]] meshio::SceneFile sceneFile(meshio::SceneFile rest) const;

  private:
    void hide(std::size_t structure);
    void note(std::size_t structure, const meshio::SceneStructure& before, bool hasOtherMaps, SceneEvents& events);
    void resolveMaps(std::size_t structure, SceneEvents& events);
    void clearTransmittedMaps(std::vector<std::size_t>& changed);

    std::vector<OpenStructure> m_structures;
    meshio::BuriedTouch m_buried = meshio::BuriedTouch::Layers;
    std::optional<meshio::Exercise> m_exercise;
    std::map<std::size_t, meshio::SceneStructure> m_undisclosed; ///< descriptions of the hidden targets, with names
};

} // namespace palpate::study
