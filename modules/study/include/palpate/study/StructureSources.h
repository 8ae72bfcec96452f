// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/haptics/HapticScene.h>
#include <palpate/meshio/LoadScene.h>
#include <palpate/session/MeasureSession.h>
#include <palpate/session/Recording.h>
#include <palpate/session/Replay.h>

#include <string>
#include <vector>

namespace palpate::study {

/// Says for a recording where a structure came from.
/// @param sha256  geometryHash of its surface, empty when it is not known
[[nodiscard]] session::StructureSource sourceOf(const meshio::SceneStructure& description, std::string sha256);
/// Says it of all structures of a scene; takes the hash of each geometry (4 ns a byte).
/// @param embeds  give the surfaces with them
[[nodiscard]] std::vector<session::StructureSource> sourcesOf(const meshio::LoadedScene& scene, bool embeds = false);
/// How a scene describes a structure of a recording: what a recording does not hold, such as colours, is as in a new
/// SceneStructure.
[[nodiscard]] meshio::SceneStructure descriptionOf(const session::StructureRecord& record);

/// The surfaces of a scene by their hash.
[[nodiscard]] session::MeshesByHash meshesByHash(const meshio::LoadedScene& scene);
/// The indices of a haptic scene by the hash of their surface, to rebuild a recording's scenes.
/// @param sources  from `sourcesOf` of the same scene
[[nodiscard]] session::SurfacesByHash surfacesByHash(const haptics::HapticScene& scene,
                                                     const std::vector<session::StructureSource>& sources);
/// Builds the index of each. @par Cost that of `indexed`, for each.
[[nodiscard]] session::SurfacesByHash indexedByHash(const session::MeshesByHash& meshes);

} // namespace palpate::study
