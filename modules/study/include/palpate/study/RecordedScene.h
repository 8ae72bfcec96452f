// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>
#include <palpate/meshio/LoadScene.h>
#include <palpate/session/MeasureSession.h>
#include <palpate/session/RecordingReader.h>

#include <filesystem>

namespace palpate::study {

/// Opens a scene file, a mesh file, a folder of mesh files, or a recording that holds its surfaces itself.
[[nodiscard]] core::Result<meshio::LoadedScene> openScene(const std::filesystem::path& path,
                                                          const meshio::ReadOptions& options = {});

/// Finds the surfaces that a recording was made on: those that it holds itself, else those of the scene.
/// @param scene  where the scene is; empty: where the recording says
/// @return NotFound when neither is there. A surface that is another one now is not in the result.
[[nodiscard]] core::Result<session::MeshesByHash> recordedSurfaces(const session::RecordingReader& reader,
                                                                   const std::filesystem::path& scene = {});

/// Opens the first scene of a recording from the surfaces that it holds itself; those that it does not hold are losses.
/// @return NotFound when it holds none
[[nodiscard]] core::Result<meshio::LoadedScene> sceneOfRecording(const std::filesystem::path& recording);

} // namespace palpate::study
