// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/geometry/SurfaceIndex.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/meshio/LoadScene.h>

#include <cstddef>
#include <functional>
#include <memory>

namespace palpate::study {

/// Returns true if a structure can be felt: it is palpable, and visible or a hidden target of an exercise. Any other
/// hidden structure must not be an invisible wall.
[[nodiscard]] PALPATE_EXPORT bool canBeFelt(const meshio::SceneStructure& structure) noexcept;
/// Returns true if a structure is drawn: it is visible and not a hidden target of an exercise.
[[nodiscard]] PALPATE_EXPORT bool isDrawn(const meshio::SceneStructure& structure) noexcept;

/// Creates a haptic structure with the name, tissue and layer of a description.
/// @param surface  surface index; null if the structure is not palpable
[[nodiscard]] PALPATE_EXPORT haptics::HapticStructure
hapticStructure(const meshio::SceneStructure& description, std::shared_ptr<const geometry::SurfaceIndex> surface);

/// Converts the surface maps of a structure to the triangle order of the index. The structure's own values fill the
/// gaps.
/// @param surface  surface index of the structure
/// @par Cost O(triangles) per map.
[[nodiscard]] PALPATE_EXPORT haptics::TissueMaps tissueMaps(const meshio::LoadedStructure& structure,
                                                            const geometry::SurfaceIndex& surface);

/// Builds the surface index for haptic rendering.
/// @par Cost O(n log n), on two threads.
[[nodiscard]] PALPATE_EXPORT std::shared_ptr<const geometry::SurfaceIndex>
indexed(const geometry::RepairedMesh& surface);

/// Builds the haptic scene for the servo. Structures keep their indices. A structure that is not palpable or has no
/// triangles gets no surface. The window also omits hidden structures and limits tissues to the device: see
/// ui/StructureModel.h.
/// @param indexOf  returns the index of the surface of a palpable structure, by number; empty: `indexed`
/// @par Cost one call of `indexOf` per palpable structure.
[[nodiscard]] PALPATE_EXPORT std::shared_ptr<const haptics::HapticScene>
hapticScene(const meshio::LoadedScene& scene,
            const std::function<std::shared_ptr<const geometry::SurfaceIndex>(std::size_t)>& indexOf = {});

/// Returns the number of palpable triangles.
[[nodiscard]] PALPATE_EXPORT std::size_t triangleCount(const haptics::HapticScene& scene);

} // namespace palpate::study
