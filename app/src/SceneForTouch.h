// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/meshio/LoadScene.h>
#include <palpate/session/Recording.h>
#include <palpate/session/Replay.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

namespace palpate::app {

/// Opens a scene file, a mesh file, a folder of mesh files, or a recording that holds its surfaces itself.
[[nodiscard]] core::Result<meshio::LoadedScene> loadSceneOrFolder(const std::filesystem::path& path,
                                                                  const meshio::ReadOptions& options = {});

/// Makes a structure's haptic copy; without one when it is not palpable.
/// @par Cost O(n log n) on two threads.
[[nodiscard]] haptics::HapticStructure structureForTouch(const meshio::LoadedStructure& structure);

/// Makes what the servo touches; structures keep their numbers.
[[nodiscard]] std::shared_ptr<const haptics::HapticScene> sceneForTouch(const meshio::LoadedScene& scene);

/// Says where each structure came from, for a recording; takes the hash of each geometry (4 ns a byte).
[[nodiscard]] std::vector<session::StructureSource> structureSources(const meshio::LoadedScene& scene);

/// The surfaces of a scene by their hash, to rebuild a recording's scenes. @param sources  from `structureSources`
[[nodiscard]] session::SurfacesByHash surfacesByHash(const haptics::HapticScene& scene,
                                                     const std::vector<session::StructureSource>& sources);

/// @return triangles that can be touched.
[[nodiscard]] std::size_t triangleCount(const haptics::HapticScene& scene);

} // namespace palpate::app
