// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/buried/FeltSurface.h>
#include <palpate/meshio/LoadScene.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace palpate::study {

/// Where a lump's ratio comes from.
enum class RatioSource : std::uint8_t
{
    Typed,  ///< `young_ratio`, or given by the person
    Moduli, ///< `young_kPa` of the lump and of its organ
    Tissue, ///< stiffness of the lump's tissue by that of the organ's
};

/// A lump of a scene.
struct LumpOf
{
    std::size_t structure; ///< number in the scene
    double ratio = 1.0;    ///< its modulus by the organ's
    RatioSource source = RatioSource::Tissue;
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

/// Finds the lumps of a scene: what the scene says lies inside an organ, and what is palpable and lies in a palpable
/// closed surface by its shape (see Layers.h). A lump in a lump belongs to the organ around both.
/// @param ratios  by the structures' names; before what the scene says
/// @return NotFound where a name of `ratios` is no lump; Empty where the scene has none
[[nodiscard]] core::Result<std::vector<OrganWithLumps>>
organsWithLumps(const meshio::LoadedScene& scene, const std::map<std::string, double>& ratios = {});

/// @return what a person reads of where a ratio comes from: "as typed", "from the moduli", "from the tissues'
/// stiffness"
[[nodiscard]] std::string_view sourceText(RatioSource source) noexcept;

/// The same as buried::feltSurface, of an organ of a scene.
[[nodiscard]] core::Result<buried::FeltSurface>
feltSurface(const meshio::LoadedScene& scene, const OrganWithLumps& organ, const buried::FeltOptions& options);

/// @return those lumps alone that a choice takes, of the organs that then have any
[[nodiscard]] std::vector<OrganWithLumps> lumpsThat(std::vector<OrganWithLumps> organs,
                                                    const std::function<bool(std::size_t structure)>& isTaken);

/// Makes the lumps of a scene that are felt through their organs: each organ gets what they make of it, and they are
/// not touched themselves, whatever their layers. A scene whose lumps are felt by their own layers stays as it is;
/// notes become warnings. Where a structure says what it lies in, those that say so are felt through it and no others.
/// @param progress  told the share done; false cancels. May be empty
/// @return Cancelled; a scene without lumps is fine
[[nodiscard]] core::Status feelBuried(meshio::LoadedScene& scene, const std::function<bool(double)>& progress = {});

} // namespace palpate::study
