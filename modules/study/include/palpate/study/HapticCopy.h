// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/SurfaceIndex.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/meshio/LoadScene.h>

#include <cstddef>
#include <memory>

namespace palpate::study {

/// How a structure is felt: its name, tissue and layer.
/// @param surface  its index; null: nothing of it is felt
[[nodiscard]] haptics::HapticStructure hapticStructure(const meshio::SceneStructure& description,
                                                       std::shared_ptr<const geometry::SurfaceIndex> surface);

/// What varies over a structure, for the tick: in the order of the index, with the structure's own values where a map
/// says nothing.
/// @param surface  the index of the structure's surface
/// @par Cost O(triangles) for each map.
[[nodiscard]] haptics::TissueMaps tissueMaps(const meshio::LoadedStructure& structure,
                                             const geometry::SurfaceIndex& surface);

/// Builds the index that a surface is felt by.
/// @par Cost O(n log n), on two threads.
[[nodiscard]] std::shared_ptr<const geometry::SurfaceIndex> indexed(const geometry::RepairedMesh& surface);

/// Makes what the servo touches. Structures keep their numbers; one that is not palpable or has no triangle has no
/// surface. The window leaves out what is hidden as well, and bounds tissues by its device: see ui/StructureModel.h.
/// @par Cost that of `indexed`, for each palpable structure.
[[nodiscard]] std::shared_ptr<const haptics::HapticScene> hapticScene(const meshio::LoadedScene& scene);

/// @return triangles that can be touched.
[[nodiscard]] std::size_t triangleCount(const haptics::HapticScene& scene);

} // namespace palpate::study
