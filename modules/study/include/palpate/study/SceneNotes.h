// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/study/Layers.h"

#include <palpate/core/Message.h>
#include <palpate/core/Tissue.h>
#include <palpate/geometry/SurfaceGap.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/meshio/LoadScene.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace palpate::study {

/// Surfaces of one layer that are closer than this without touching leave a gap into which a point contact can fall. A
/// fingertip of 0.5 mm bridges the gap. [mm]
inline constexpr double kNarrowGap_mm = 0.2;
/// Surfaces within this distance count as touching: the god-object's skin, and more than the rounding of coordinates in
/// files. [mm]
inline constexpr double kTouching_mm = 1e-4;

/// A seam between touching neighbours of one layer is palpable above this stiffness ratio.
inline constexpr double kPalpableSeamRatio = 2.0;

/// Structure properties for the neighbour tests.
struct NeighbourSurface
{
    std::string name;
    std::uint32_t layer = 0;
    const geometry::RepairedMesh* surface = nullptr;
    const geometry::SurfaceIndex* index = nullptr; ///< null: not palpable, ignored
    double stiffness_N_per_mm = 0.0;               ///< see pressStiffness
};

/// Returns force divided by depth of a light press of 2 mm [N/mm], without maps and buried lumps.
[[nodiscard]] double pressStiffness(const core::Tissue& tissue);

/// Returns the structures of a scene in order, without lumps that are transmitted through their organ because these
/// have no contact surface. Valid for the lifetime of `scene` and `felt`.
/// @param felt  haptic scene with the same structures (see `hapticScene`)
[[nodiscard]] std::vector<NeighbourSurface> neighbours(const meshio::LoadedScene& scene,
                                                       const haptics::HapticScene& felt);

/// Returns a sentence for each pair of structures in one layer that are closer than kNarrowGap_mm without touching or
/// nesting, and for each pair that touch or intersect and whose stiffness differs by more than kPalpableSeamRatio: the
/// force steps where the hand crosses the seam (resources/docs/god-object.md, "Several structures in one contact").
/// @par Cost See geometry::nearestWithin, on all cores. Not for the servo thread.
[[nodiscard]] std::vector<core::Message> borderNotes(std::span<const NeighbourSurface> surfaces, const Layering& found);
/// Computes the layering and calls the function above.
[[nodiscard]] std::vector<core::Message> borderNotes(std::span<const NeighbourSurface> surfaces);

/// Returns a sentence for each structure inside another one of the same layer, which cannot be felt through that one.
[[nodiscard]] std::vector<core::Message> maskedLumpNotes(std::span<const NeighbourSurface> surfaces,
                                                         const Layering& found);

/// Returns both kinds of notes for a scene.
[[nodiscard]] std::vector<core::Message> neighbourNotes(const meshio::LoadedScene& scene,
                                                        const haptics::HapticScene& felt);

} // namespace palpate::study
