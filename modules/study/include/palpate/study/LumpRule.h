// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Message.h>
#include <palpate/geometry/Repair.h>
#include <palpate/meshio/LoadScene.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace palpate::study {

/// A structure as LumpRule sees it.
struct PlacedStructure
{
    const meshio::SceneStructure* description = nullptr;
    const geometry::RepairedMesh* surface = nullptr; ///< null: removed from the scene, or without triangles
    std::optional<std::size_t> in;                   ///< next structure around it that can be felt (see Layers.h)
};

/// Decides which structures of a scene are lumps and through which organ each of them is felt. Window and command line
/// use this one rule.
///
/// A structure that is hidden, not palpable or removed is neither felt through an organ nor an organ. (`palpate felt`
/// predicts lumps that name their organ even so.) The organ of a structure is the one that its entry in the scene names
/// (`inside`). Without such an entry it is the innermost structure around it that
/// has a reliable interior (closed, normals outwards) and is no lump candidate itself; if all of them are candidates,
/// the outermost one.
/// @par Thread A value; the structures must outlive it.
class PALPATE_EXPORT LumpRule
{
  public:
    /// An organ, or the reason why there is none.
    struct Organ
    {
        std::optional<std::size_t> organ;
        core::Message whyNot; ///< a clause: "liver is hidden or not palpable"; empty with an organ
        explicit operator bool() const noexcept { return organ.has_value(); }
    };

    /// @param lumps  names of structures that are lumps whatever their entry says
    explicit LumpRule(std::vector<PlacedStructure> structures, std::set<std::string> lumps = {});

    /// Returns the organ around a structure, whether or not the structure is a lump.
    [[nodiscard]] Organ organAround(std::size_t structure) const;
    /// Returns the organ of a lump: of a structure whose entry names an organ, or of a lump candidate.
    [[nodiscard]] Organ organOf(std::size_t structure) const;
    /// Returns the organ through which a structure is felt in a scene with BuriedTouch::Felt: the organ of a lump. If
    /// any structure of the scene names its organ, only such structures are felt through one.
    [[nodiscard]] Organ feltThrough(std::size_t structure) const;
    /// Returns the number of structures around one that can be felt, at most haptics::kMaxLayers - 1: the layer of a
    /// lump that ought to be felt through its organ but whose effect is not known or not computed yet.
    [[nodiscard]] std::uint32_t layerWithin(std::size_t structure) const;

  private:
    [[nodiscard]] bool isThere(std::size_t structure) const;
    [[nodiscard]] bool isCandidate(std::size_t structure) const;

    std::vector<PlacedStructure> m_structures;
    std::set<std::string> m_lumps;
    bool m_areNamed; ///< a structure names its organ
};

} // namespace palpate::study
