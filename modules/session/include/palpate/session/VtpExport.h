// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/MeasureSession.h"
#include "palpate/session/RecordingReader.h"

#include <palpate/core/Status.h>

#include <filesystem>

namespace palpate::session {

/// Writes the path of the HIP as a VTP polyline, in LPS and mm, cut where ticks or the hand are missing. Point arrays:
/// `time_s`, `force_N`, `depth_mm`, `force` and `god_object` (three components), `structure` (-1 in free space).
/// Atomic.
[[nodiscard]] core::Status writePathVtp(const std::filesystem::path& path, const RecordingReader& reader);

/// Writes the surfaces that were touched as a VTP, in LPS and mm. Point arrays `dwell_s`, `peak_force_N`, `coverage`
/// (0 or 1); cell array `StructureId` into the field array `StructureNames`. Atomic.
/// @return Empty when nothing was touched
[[nodiscard]] core::Status writeSurfaceVtp(const std::filesystem::path& path, const SessionMeasures& measures);

} // namespace palpate::session
