// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/study/Layers.h"

#include <palpate/core/Tissue.h>
#include <palpate/geometry/SurfaceGap.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/meshio/LoadScene.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace palpate::study {

/// Surfaces of one layer that are nearer than this without touching have a gap that a point contact falls into; a
/// fingertip of 0.5 mm rides over it. [mm]
inline constexpr double kNarrowGap_mm = 0.2;
/// Surfaces as near as this touch: the god-object's skin, and more than files round coordinates by. [mm]
inline constexpr double kTouching_mm = 1e-4;

/// Neighbours in a layer that touch and differ by more than this factor in stiffness have a seam that is felt.
inline constexpr double kFeltSeam = 2.0;

/// A structure as its neighbours matter.
struct NeighbourSurface
{
    std::string name;
    std::uint32_t layer = 0;
    const geometry::RepairedMesh* surface = nullptr;
    const geometry::SurfaceIndex* index = nullptr; ///< null: not felt, so that it counts for nothing
    double stiffness_N_per_mm = 0.0;               ///< see pressStiffness
};

/// @return force by depth of a light press, 2 mm deep [N/mm]; maps and what lies below do not count
[[nodiscard]] double pressStiffness(const core::Tissue& tissue);

/// @return those of a scene, in its order. What is felt through its organ does not count: its own surface is not
/// touched. They are valid as long as `scene` and `felt` are.
/// @param felt  made of `scene`, structure by structure (see `hapticScene`)
[[nodiscard]] std::vector<NeighbourSurface> neighbours(const meshio::LoadedScene& scene,
                                                       const haptics::HapticScene& felt);

/// @return a sentence for each two structures of one layer that come nearer than kNarrowGap_mm without touching, of
/// which none lies in the other; and for each two that touch or cross and differ in stiffness by more than kFeltSeam:
/// the force steps where the hand passes from one to the other (resources/docs/god-object.md, "Several structures in
/// one contact").
/// @par Cost See geometry::nearestWithin, on all cores. Any thread but the servo's.
[[nodiscard]] std::vector<std::string> borderNotes(std::span<const NeighbourSurface> surfaces, const Layering& found);
/// The same, and finds out itself what lies in what.
[[nodiscard]] std::vector<std::string> borderNotes(std::span<const NeighbourSurface> surfaces);

/// @return a sentence for each structure that lies in another one of its layer, and is therefore not felt through it.
[[nodiscard]] std::vector<std::string> unfeltLumpNotes(std::span<const NeighbourSurface> surfaces,
                                                       const Layering& found);

/// Both of these for a scene.
[[nodiscard]] std::vector<std::string> neighbourNotes(const meshio::LoadedScene& scene,
                                                      const haptics::HapticScene& felt);

} // namespace palpate::study
