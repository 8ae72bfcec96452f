// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/study/BuriedLumps.h"

#include <palpate/core/Status.h>
#include <palpate/meshio/LoadScene.h>
#include <palpate/session/MeasureSession.h>
#include <palpate/session/RecordingReader.h>

#include <filesystem>
#include <optional>

namespace palpate::study {

/// Opens a scene file, a mesh file, a folder of mesh files, or what a recording was made on.
/// @param felt  gets what was computed of lumps that are felt through their organ; may be null
[[nodiscard]] core::Result<meshio::LoadedScene> openScene(const std::filesystem::path& path,
                                                          const meshio::ReadOptions& options = {},
                                                          std::vector<FeltOrgan>* felt = nullptr);

/// Says for a recording which scene it is made on: its absolute path, its path from the recording's folder where it
/// lies in it or below, and of a scene file its hash.
/// @param scene, recording  empty when there is none; then nothing is said
void nameScene(session::RecordingInfo& info, const std::filesystem::path& scene,
               const std::filesystem::path& recording);

/// Finds the scene or mesh that a recording says it was made on: where it was, else beside the recording.
[[nodiscard]] std::optional<std::filesystem::path> recordedSceneFile(const session::RecordingReader& reader);

/// Finds the surfaces that a recording was made on: those that it holds itself, else those of the scene.
/// @param scene  where the scene is; empty: where the recording says
/// @return NotFound when neither is there. A surface that is another one now is not in the result.
[[nodiscard]] core::Result<session::MeshesByHash> recordedSurfaces(const session::RecordingReader& reader,
                                                                   const std::filesystem::path& scene = {});

/// Opens the first scene of a recording as it was felt: its structures with the recorded tissue, laws, maps and layers,
/// and its findings. Surfaces are those that it holds itself, else those of the mesh files. Colours and opacity are
/// those of then; an older recording has none: they, and of any the camera and what is hidden, come from the scene
/// file, where that is still there.
/// @return NotFound when no surface can be had. One that is another now than was recorded is a loss, and is opened.
[[nodiscard]] core::Result<meshio::LoadedScene> sceneOfRecording(const std::filesystem::path& recording,
                                                                 const meshio::ReadOptions& options = {});

/// @return true when a ball touched, not a point.
[[nodiscard]] bool hasFingertip(const session::RecordingReader& reader);

/// How near the contact must come to count as touched, where no option says it: the radius of the fingertip that
/// touched in the recording, but at least 1 mm; 5 mm where a point touched; more on surfaces so large that they are not
/// measured as finely. [mm]
[[nodiscard]] double usualDistance_mm(const session::RecordingReader& reader, const session::MeshesByHash& surfaces);

} // namespace palpate::study
