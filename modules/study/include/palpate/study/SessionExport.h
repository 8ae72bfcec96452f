// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>
#include <palpate/session/MeasureSession.h>
#include <palpate/session/RecordingReader.h>

#include <QJsonObject>

#include <filesystem>
#include <functional>
#include <string>

namespace palpate::study {

// What a recording says, in other forms. Files are written whole or not at all.

/// Told how far an export is, 0 … 1; returns false to cancel it.
using ExportProgress = std::function<bool(double share)>;

/// Writes every tick as CSV (session::TickCsv::Rows::Session). An event of a tick that is missing stands with the next.
/// @return Cancelled when `progress` said so
[[nodiscard]] core::Status exportTicks(const session::RecordingReader& reader, const std::filesystem::path& path,
                                       const ExportProgress& progress = {});

/// Writes the path of the HIP as a VTP polyline, in LPS and mm, cut where ticks or the hand are missing. Point arrays:
/// `time_s`, `force_N`, `depth_mm`, `force` and `god_object` (three components), `structure` (-1 in free space).
/// @return Empty when there is no tick with a hand
[[nodiscard]] core::Status exportPath(const session::RecordingReader& reader, const std::filesystem::path& path,
                                      const ExportProgress& progress = {});

/// Writes the surfaces that were touched as a VTP, in LPS and mm. Point arrays `dwell_s`, `peak_force_N`, `coverage`
/// (0 or 1); cell array `StructureId` into the field array `StructureNames`.
/// @return Empty when nothing was touched
[[nodiscard]] core::Status exportSurface(const session::SessionMeasures& measures, const std::filesystem::path& path);

/// @return where the touched surface goes when the path goes to `path`: "P.vtp" gives "P-surface.vtp".
[[nodiscard]] std::filesystem::path surfaceFileOf(const std::filesystem::path& path);

/// A person names the path's file, not this one: it may be new or replace an older export, and no other file.
/// @return BadCommandLine when there is another file
[[nodiscard]] core::Status checkSurfaceFile(const std::filesystem::path& surface);

/// All measures as one JSON document, see resources/docs/measures.md.
[[nodiscard]] std::string measuresJson(const session::SessionMeasures& measures);
/// The sums alone, as every JSON that the program writes says them.
[[nodiscard]] QJsonObject sumsJson(const session::Measures& sums);

} // namespace palpate::study
