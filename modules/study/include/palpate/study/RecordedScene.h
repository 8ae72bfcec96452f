// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/study/BuriedLumps.h"

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>
#include <palpate/meshio/LoadScene.h>
#include <palpate/session/MeasureSession.h>
#include <palpate/session/RecordingReader.h>

#include <filesystem>
#include <optional>

namespace palpate::study {

/// Opens a scene file, a mesh file, a folder of mesh files, or the scene of a recording.
/// @param felt  receives the results for buried lumps; may be null
[[nodiscard]] PALPATE_EXPORT core::Result<meshio::LoadedScene> openScene(const std::filesystem::path& path,
                                                                         const meshio::ReadOptions& options = {},
                                                                         std::vector<OrganPalpability>* felt = nullptr);

/// Stores the scene of a recording in `info`: path and hash of a scene file. The writer of a recording stores the path
/// relative to the folder of the recording.
/// @param scene  no effect if empty
PALPATE_EXPORT void setSceneSource(session::RecordingInfo& info, const std::filesystem::path& scene);

/// Finds the scene or mesh of a recording: relative to the folder of the recording, at the absolute path of an older
/// recording, else by name beside the recording.
[[nodiscard]] PALPATE_EXPORT std::optional<std::filesystem::path>
recordedSceneFile(const session::RecordingReader& reader);

/// Finds the mesh file of a recorded structure in the same places. @return the recorded path if it is in none of them
[[nodiscard]] PALPATE_EXPORT std::filesystem::path recordedMeshFile(const session::RecordingReader& reader,
                                                                    const session::StructureRecord& structure);

/// Finds the surfaces of a recording: embedded surfaces, else the surfaces of the scene.
/// @param scene  path of the scene; empty: as stored in the recording
/// @return NotFound if neither is available. Surfaces that have changed since are omitted.
[[nodiscard]] PALPATE_EXPORT core::Result<session::MeshesByHash>
recordedSurfaces(const session::RecordingReader& reader, const std::filesystem::path& scene = {});

/// Opens the first scene of a recording with the recorded tissues, laws, maps, layers and findings. Uses embedded
/// surfaces, else the mesh files. Colours and opacity are as recorded. Older recordings lack these; they come from the
/// scene file if still available, like the camera and the hidden structures of any recording.
/// @return NotFound if no surface is available. A surface that has changed since is opened and reported as a loss.
[[nodiscard]] PALPATE_EXPORT core::Result<meshio::LoadedScene>
sceneOfRecording(const std::filesystem::path& recording, const meshio::ReadOptions& options = {});

/// Opens a scene in another place than recorded with the unit, the axes and the surface options of the recording. A
/// scene file states its own.
[[nodiscard]] PALPATE_EXPORT core::Result<meshio::LoadedScene> openAsRecorded(const session::RecordingReader& reader,
                                                                              const std::filesystem::path& scene);

/// Returns true for contact with a fingertip ball, false for point contact.
[[nodiscard]] PALPATE_EXPORT bool hasFingertip(const session::RecordingReader& reader);

/// Returns the default distance that counts as touched [mm]: the radius of the recorded fingertip, at least 1 mm; 5 mm
/// for point contact; more for surfaces too large to be measured at that resolution.
[[nodiscard]] PALPATE_EXPORT double defaultDistance_mm(const session::RecordingReader& reader,
                                                       const session::MeshesByHash& surfaces);

} // namespace palpate::study
