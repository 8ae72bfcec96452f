// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/meshio/LoadScene.h>
#include <palpate/session/MeasureSession.h>
#include <palpate/session/Recording.h>
#include <palpate/session/Replay.h>

#include <string>
#include <vector>

namespace palpate::study {

/// Describes the origin of a structure for a recording.
/// @param sha256  geometryHash of the surface; empty if unknown
[[nodiscard]] PALPATE_EXPORT session::StructureSource sourceOf(const meshio::SceneStructure& description,
                                                               std::string sha256);
/// Describes the origin of all structures of a scene. Hashes every geometry (4 ns per byte).
/// @param embeds  include the surfaces
[[nodiscard]] PALPATE_EXPORT std::vector<session::StructureSource> sourcesOf(const meshio::LoadedScene& scene,
                                                                             bool embeds = false);
/// Converts a recorded structure to a scene description. Properties that a recording does not store, such as colours,
/// get the defaults of SceneStructure.
[[nodiscard]] PALPATE_EXPORT meshio::SceneStructure descriptionOf(const session::StructureRecord& record);

/// Returns the surfaces of a scene by hash.
[[nodiscard]] PALPATE_EXPORT session::MeshesByHash meshesByHash(const meshio::LoadedScene& scene);
/// Returns the surface indices of a haptic scene by the hash of the surface, to rebuild the scenes of a recording.
/// @param sources  from `sourcesOf` for the same scene
[[nodiscard]] PALPATE_EXPORT session::SurfacesByHash
surfacesByHash(const haptics::HapticScene& scene, const std::vector<session::StructureSource>& sources);
/// Builds the index of each surface. @par Cost one call of `indexed` per surface.
[[nodiscard]] PALPATE_EXPORT session::SurfacesByHash indexedByHash(const session::MeshesByHash& meshes);

} // namespace palpate::study
