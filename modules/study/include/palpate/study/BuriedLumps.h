// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/study/StiffnessRatio.h"

#include <palpate/buried/FeltSurface.h>
#include <palpate/meshio/LoadScene.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace palpate::study {

/// A lump of a scene.
struct LumpOf
{
    std::size_t structure;               ///< number in the scene
    std::optional<StiffnessRatio> ratio; ///< its modulus by the organ's; nothing: not known
    friend bool operator==(const LumpOf&, const LumpOf&) = default;
};

/// An organ of a scene with the lumps in it.
struct OrganWithLumps
{
    std::size_t organ; ///< number in the scene
    double radius_mm;  ///< of the finger's contact: as the scene says, else 5
    std::vector<LumpOf> lumps;

    /// @param scene  that it was found in
    [[nodiscard]] std::vector<buried::BuriedLump> shapes(const meshio::LoadedScene& scene) const;
    friend bool operator==(const OrganWithLumps&, const OrganWithLumps&) = default;
};
inline constexpr double kUsualRadius_mm = 5.0;

/// What can be felt through one organ of a scene.
struct FeltOrgan
{
    OrganWithLumps organ;
    buried::FeltSurface felt;
};

/// @return true for a structure that is a lump when it lies in an organ and no scene says so: its name is that of a
/// lump or says nothing, or its ratio is given.
[[nodiscard]] bool mayBeLump(const meshio::SceneStructure& structure);

/// Finds the lumps of a scene: what the scene says lies inside an organ, and what may be a lump, is palpable and lies
/// in a palpable closed surface by its shape (see Layers.h). A lump in a lump belongs to the organ around both.
/// @param ratios  by the structures' names; before what the scene says
/// @return NotFound where a name of `ratios` is no lump; Empty where the scene has none
[[nodiscard]] core::Result<std::vector<OrganWithLumps>>
organsWithLumps(const meshio::LoadedScene& scene, const std::map<std::string, double>& ratios = {});

/// The same as buried::feltSurface, of an organ of a scene.
[[nodiscard]] core::Result<buried::FeltSurface>
feltSurface(const meshio::LoadedScene& scene, const OrganWithLumps& organ, const buried::FeltOptions& options);

/// Computes what can be felt of all lumps of a scene, touched lightly and pressed 2, 4 and 8 mm.
/// @param known  results that still hold are taken from here
/// @param notes  gets a sentence of each organ that cannot be judged, and of each lump that was left out
/// @return empty for a scene without lumps; Cancelled
[[nodiscard]] core::Result<std::vector<FeltOrgan>> feltOrgans(const meshio::LoadedScene& scene,
                                                              std::vector<FeltOrgan> known = {},
                                                              std::vector<std::string>* notes = nullptr,
                                                              const std::function<bool(double)>& progress = {});

/// @return those lumps alone that a choice takes, of the organs that then have any
[[nodiscard]] std::vector<OrganWithLumps> lumpsThat(std::vector<OrganWithLumps> organs,
                                                    const std::function<bool(std::size_t structure)>& isTaken);

/// Makes the lumps of a scene that are felt through their organs: each organ gets what they make of it, and they are
/// not touched themselves, whatever their layers. A scene whose lumps are felt by their own layers stays as it is;
/// notes become warnings. Where a structure says what it lies in, those that say so are felt through it and no others.
/// A lump whose stiffness ratio is not known is left as it is, with a warning.
/// @param progress  told the share done; false cancels. May be empty
/// @param felt  gets what was computed; may be null
/// @return Cancelled; a scene without lumps is fine
[[nodiscard]] core::Status feelBuried(meshio::LoadedScene& scene, const std::function<bool(double)>& progress = {},
                                      std::vector<FeltOrgan>* felt = nullptr);

} // namespace palpate::study
