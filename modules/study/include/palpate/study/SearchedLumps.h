// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/study/BuriedLumps.h"

#include <palpate/core/Export.h>
#include <palpate/meshio/LoadScene.h>
#include <palpate/session/MeasureSession.h>

#include <functional>
#include <vector>

namespace palpate::study {

/// Evaluates how thoroughly lumps were searched for, to distinguish a lump that was missed from one that could not be
/// found: computes where a trained hand detects each lump when pressing, and which part of that area was pressed deep
/// enough in the recording. Places that the model cannot evaluate are omitted.
/// @param scene  scene of the recording
/// @param distance_mm  distance within which the contact counts as touching a place [mm]
/// @param progress  progress callback (0 to 1). Return false to cancel. May be empty
/// @return empty for a scene without lumps; organs that cannot be evaluated are omitted; Cancelled, or the read error
/// @par Thread Any. Do not use the reader from other threads at the same time.
[[nodiscard]] PALPATE_EXPORT core::Result<std::vector<session::LumpSearch>>
    PALPATE_EXPORT searchedLumps(const session::RecordingReader& reader, const meshio::LoadedScene& scene,
                                 double distance_mm, const std::function<bool(double)>& progress = {});
/// Same with known results for the lumps of the scene. @param organs  from `computePalpability`
[[nodiscard]] PALPATE_EXPORT core::Result<std::vector<session::LumpSearch>>
    PALPATE_EXPORT searchedLumps(const session::RecordingReader& reader, const meshio::LoadedScene& scene,
                                 double distance_mm, std::vector<OrganPalpability> organs,
                                 const std::function<bool(double)>& progress = {});

} // namespace palpate::study
