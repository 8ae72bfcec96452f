// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/study/BuriedLumps.h"

#include <palpate/core/Export.h>
#include <palpate/meshio/LoadScene.h>
#include <palpate/session/MeasureSession.h>

#include <vector>

namespace palpate::study {

/// Measures a recording as session::measureSession does and evaluates in the same pass how thoroughly its lumps were
/// searched for, to distinguish a lump that was missed from one that could not be found: where a trained hand detects
/// each lump when pressing, and which part of that area was pressed deep enough in the recording. Places that the model
/// cannot evaluate are omitted.
/// @param scene  scene of the recording
/// @param organs  results for the lumps of the scene, from `computePalpability`; empty: no lumps
/// @return the errors of session::measureSession
/// @par Thread Any. Do not use the reader from other threads at the same time.
[[nodiscard]] PALPATE_EXPORT core::Result<session::SessionMeasures>
measureSearch(const session::RecordingReader& reader, const session::MeshesByHash& meshes,
              const meshio::LoadedScene& scene, std::vector<OrganPalpability> organs, session::MeasureOptions options);

} // namespace palpate::study
