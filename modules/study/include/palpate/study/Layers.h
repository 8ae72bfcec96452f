// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Message.h>
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

/// Surface of a structure for the containment test.
struct LayeredSurface
{
    const geometry::RepairedMesh* surface = nullptr; ///< null: never inside another structure
    const geometry::SurfaceIndex* index =
        nullptr; ///< index of `surface`; null if not palpable: contains no other structure
};

/// Containment of structures and the resulting haptic layers.
struct Layering
{
    struct Structure
    {
        std::uint32_t layer = 0;         ///< 0 is the outermost layer
        std::optional<std::size_t> in;   ///< smallest enclosing structure
        std::optional<std::size_t> twin; ///< earlier structure with the same surface
        std::optional<std::size_t>
            unreliableParent; ///< would be inside this structure, which has no reliable interior: not layered
        /// Number of nested structures around this one. Exceeds `layer` if merged into the last layer.
        std::uint32_t depth = 0;
    };
    std::vector<Structure> structures;

    /// Returns true if any structure lies below another one.
    [[nodiscard]] bool isLayered() const;
    /// Returns the indices in ascending order, but with each structure followed by its contents.
    [[nodiscard]] std::vector<std::size_t> order() const;
    /// Returns the layering of structures that were permuted into that order.
    [[nodiscard]] Layering inOrder(const std::vector<std::size_t>& order) const;
    /// Returns messages for the user, one sentence each. Non-palpable structures are left out of messages about layers.
    /// @param names  names of the structures
    /// @param isFelt  one entry per structure: palpable
    [[nodiscard]] std::vector<core::Message> sentences(const std::vector<std::string>& names,
                                                       const std::vector<bool>& isFelt) const;
    /// Returns the smallest palpable structure around another one.
    [[nodiscard]] std::optional<std::size_t> palpableParent(std::size_t structure,
                                                            const std::vector<bool>& isFelt) const;
};

/// Returns true if the surface has a reliable interior: closed everywhere, normals outwards. Edges with more than two
/// triangles are allowed, because a surface counts as closed only if such edges are traversed equally often in both
/// directions.
[[nodiscard]] bool hasReliableInterior(const geometry::MeshReport& report) noexcept;

/// Returns true if all sampled vertices of `inner` (up to kSamples, evenly distributed) are not outside of `outer`.
/// @par Cost about 2 µs per sample
[[nodiscard]] bool isWhollyInside(const geometry::RepairedMesh& inner, const geometry::SurfaceIndex& outer);

/// Determines the nesting of structures. B is in A if A has a reliable interior and the larger volume, and at least
/// kInsideShare of up to kSamples evenly distributed vertices of B are inside A. The layer of B is one below the
/// deepest layer around B, at most haptics::kMaxLayers - 1. Structures with equal surfaces share a layer.
/// @par Cost Bounding boxes first, then two or three rays per vertex: 0.5 ms for a nested pair. Uses all cores; not for
///           the servo thread. The result does not depend on the number of cores.
[[nodiscard]] Layering layering(std::span<const LayeredSurface> surfaces);
inline constexpr double kInsideShare = 0.9;
inline constexpr std::size_t kSamples = 256;

/// Assigns the layers from the nesting to the structures of a scene and of the haptic scene.
/// @param felt  haptic scene with the same structures (see `hapticScene`)
/// @return messages about the changes for the user
std::vector<core::Message> setLayers(meshio::LoadedScene& scene, std::shared_ptr<const haptics::HapticScene>& felt);

} // namespace palpate::study
