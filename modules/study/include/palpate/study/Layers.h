// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/MeshReport.h>
#include <palpate/geometry/SurfaceIndex.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/meshio/LoadScene.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace palpate::study {

/// A structure as containment sees it.
struct LayeredSurface
{
    const geometry::RepairedMesh* surface = nullptr; ///< null: lies in nothing
    const geometry::SurfaceIndex* index = nullptr;   ///< of `surface`; null where it is not felt: nothing lies in it
};

/// What lies in what, and the layers in which all of it is felt.
struct Layering
{
    struct Structure
    {
        std::uint32_t layer = 0;             ///< 0 is the outermost
        std::optional<std::size_t> in;       ///< the smallest structure that it lies in
        std::optional<std::size_t> twin;     ///< an earlier structure that is the same surface
        std::optional<std::size_t> unsureIn; ///< would lie in this one, which has no sure inside: not layered
        /// How many structures lie around it, one in the other; more than `layer` when it was merged into the last.
        std::uint32_t depth = 0;
    };
    std::vector<Structure> structures;

    /// True when something lies below something else.
    [[nodiscard]] bool isLayered() const;
    /// @return the structures' numbers, each followed by what lies in it, else ascending.
    [[nodiscard]] std::vector<std::size_t> order() const;
    /// @return the same of structures that were put into that order.
    [[nodiscard]] Layering inOrder(const std::vector<std::size_t>& order) const;
    /// What a person should know, one sentence an entry. What the hand passes through is in none of those about layers.
    /// @param names   of the structures
    /// @param isFelt  one entry a structure
    [[nodiscard]] std::vector<std::string> sentences(const std::vector<std::string>& names,
                                                     const std::vector<bool>& isFelt) const;
    /// @return the smallest structure around one that is felt itself.
    [[nodiscard]] std::optional<std::size_t> feltAround(std::size_t structure, const std::vector<bool>& isFelt) const;
};

/// A surface with an inside that can be relied on: closed everywhere, its normals outwards. Edges of more than two
/// triangles may be there: each is passed equally often both ways, or the surface would not count as closed.
[[nodiscard]] bool hasSureInside(const geometry::MeshReport& report) noexcept;

/// @return true when none of up to kSamples vertices of `inner`, evenly spread, is outside of `outer`.
/// @par Cost some 2 us a sample
[[nodiscard]] bool isWhollyInside(const geometry::RepairedMesh& inner, const geometry::SurfaceIndex& outer);

/// Finds out what lies in what: B in A when A has a sure inside, encloses the larger volume, and holds at least
/// kInsideShare of up to kSamples vertices of B, evenly spread. B's layer is one below the deepest that it lies in, at
/// most haptics::kMaxLayers - 1. Twins share a layer.
/// @par Cost Boxes first; else two or three rays a vertex: 0.5 ms for a pair that is inside. All cores, any thread but
///      the servo's; the result does not depend on the number of cores.
[[nodiscard]] Layering layering(std::span<const LayeredSurface> surfaces);
inline constexpr double kInsideShare = 0.9;
inline constexpr std::size_t kSamples = 256;

/// Gives the structures of a scene, and a felt copy of it, the layers that follow from what lies in what.
/// @param felt  made of `scene`, structure by structure (see `hapticScene`)
/// @return sentences about what was done, for a person
std::vector<std::string> setLayers(meshio::LoadedScene& scene, std::shared_ptr<const haptics::HapticScene>& felt);

} // namespace palpate::study
