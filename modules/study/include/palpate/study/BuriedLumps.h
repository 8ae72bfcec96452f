// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/study/StiffnessRatio.h"

#include <palpate/buried/FeltSurface.h>
#include <palpate/core/Export.h>
#include <palpate/core/Message.h>
#include <palpate/meshio/LoadScene.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace palpate::study {

/// Lump in a scene.
struct SceneLump
{
    std::size_t structure;               ///< index in the scene
    std::optional<StiffnessRatio> ratio; ///< ratio of Young's moduli, lump to organ; empty: unknown
    friend bool operator==(const SceneLump&, const SceneLump&) = default;
};

/// Organ of a scene and the lumps inside.
struct PALPATE_EXPORT OrganWithLumps
{
    std::size_t organ; ///< index in the scene
    double radius_mm;  ///< radius of the finger's contact [mm]: from the scene, else kDefaultContactRadius_mm
    std::vector<SceneLump> lumps;

    /// @param scene  scene that contains the organ
    [[nodiscard]] std::vector<buried::BuriedLump> shapes(const meshio::LoadedScene& scene) const;
    friend bool operator==(const OrganWithLumps&, const OrganWithLumps&) = default;
};
inline constexpr double kDefaultContactRadius_mm = 5.0;

/// Result of the lump computation for one organ.
struct OrganPalpability
{
    OrganWithLumps organ;
    buried::FeltSurface felt;
};

/// Returns true if a structure inside an organ is treated as a lump without an explicit entry in the scene: the name
/// refers to a lump or to unknown anatomy, or the scene gives a stiffness ratio.
[[nodiscard]] PALPATE_EXPORT bool isLumpCandidate(const meshio::SceneStructure& structure);

/// Lump inside a surface that is open or inside out, by index in the scene.
struct LumpInOpenSurface
{
    std::size_t lump = 0;
    std::size_t around = 0;
};

/// Finds the lumps of a scene and their organs by LumpRule.
/// @param ratios  stiffness ratios by structure name; override the ratios in the scene
/// @param leftOut  receives the lumps that were left out because the surface around them is open or inside out; may be
/// null
/// @return NotFound if a name in `ratios` is not a lump; Empty if the scene has no lumps
[[nodiscard]] PALPATE_EXPORT core::Result<std::vector<OrganWithLumps>>
organsWithLumps(const meshio::LoadedScene& scene, const std::map<std::string, double>& ratios = {},
                std::vector<LumpInOpenSurface>* leftOut = nullptr);

/// Describes why a surface has no reliable interior, in a clause: "the surface of %1 has a hole of 12 mm".
[[nodiscard]] PALPATE_EXPORT core::Message openSurface(const std::string& name, const geometry::RepairedMesh& surface);

/// Computes buried::feltSurface for an organ of a scene.
[[nodiscard]] PALPATE_EXPORT core::Result<buried::FeltSurface> PALPATE_EXPORT
feltSurface(const meshio::LoadedScene& scene, const OrganWithLumps& organ, const buried::FeltOptions& options);

/// Computes how palpable all lumps of a scene are, for light touch and for presses of 2, 4 and 8 mm.
/// @param known  earlier results; reused if still valid
/// @param notes  receives a sentence for each organ that cannot be evaluated and for each omitted lump
/// @return empty for a scene without lumps; Cancelled
[[nodiscard]] PALPATE_EXPORT core::Result<std::vector<OrganPalpability>>
    PALPATE_EXPORT computePalpability(const meshio::LoadedScene& scene, std::vector<OrganPalpability> known = {},
                                      std::vector<core::Message>* notes = nullptr,
                                      const std::function<bool(double)>& progress = {});

/// Filters lumps by a predicate. @return organs with at least one accepted lump
[[nodiscard]] PALPATE_EXPORT std::vector<OrganWithLumps>
filterLumps(std::vector<OrganWithLumps> organs, const std::function<bool(std::size_t structure)>& isTaken);

/// Computes the effect of buried lumps on their organs, for scenes with lumps transmitted through the organ. The
/// surface of such a lump is removed from contact in any layer. Scenes with lumps in separate layers stay unchanged;
/// notes become warnings. LumpRule::feltThrough decides which lumps are transmitted. If the effect of one of them
/// cannot be computed, because its stiffness ratio is unknown or the model does not apply, it becomes a layer below the
/// structures around it, and a warning gives the reason.
/// @param progress  progress callback (0 to 1). Return false to cancel. May be empty
/// @param felt  receives the computed results; may be null
/// @return Cancelled; Ok for a scene without lumps
[[nodiscard]] PALPATE_EXPORT core::Status applyBuriedLumps(meshio::LoadedScene& scene,
                                                           const std::function<bool(double)>& progress = {},
                                                           std::vector<OrganPalpability>* felt = nullptr);

} // namespace palpate::study
