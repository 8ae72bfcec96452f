// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>
#include <palpate/session/MeasureSession.h>
#include <palpate/session/RecordingReader.h>

#include <QJsonObject>

#include <filesystem>
#include <functional>
#include <span>
#include <string>

namespace palpate::study {

// Export of recordings to other formats. Files are written atomically.

/// Progress callback (0 to 1). Return false to cancel.
using ExportProgress = std::function<bool(double share)>;

/// Writes every tick as CSV (session::TickCsv::Rows::Session). Events of a missing tick are attached to the next tick.
/// @param columns  names of the columns to write, in their order; empty: all
/// @return Cancelled if `progress` returned false, BadCommandLine for an unknown column
[[nodiscard]] PALPATE_EXPORT core::Status exportTicks(const session::RecordingReader& reader,
                                                      const std::filesystem::path& path,
                                                      const ExportProgress& progress = {},
                                                      std::span<const std::string> columns = {});

/// Writes the path of the HIP as a VTP polyline, in LPS and mm, interrupted where ticks or the hand are missing. Point
/// arrays: `time_s`, `force_N`, `depth_mm`, `force` and `god_object` (three components), `structure` (-1 in free
/// space).
/// @return Empty if no tick has a hand
[[nodiscard]] PALPATE_EXPORT core::Status exportPath(const session::RecordingReader& reader,
                                                     const std::filesystem::path& path,
                                                     const ExportProgress& progress = {});

/// Writes the touched surfaces as VTP, in LPS and mm. Point arrays `dwell_s`, `peak_force_N`, `mean_force_N`,
/// `stiffness_N_per_mm`, `visits`, `coverage` (0 or 1); cell array `StructureId`, an index into the field array
/// `StructureNames`.
/// @return Empty if nothing was touched
[[nodiscard]] PALPATE_EXPORT core::Status exportSurface(const session::SessionMeasures& measures,
                                                        const std::filesystem::path& path);

/// Returns the file for the touched surfaces next to the path's file: "P.vtp" gives "P-surface.vtp".
[[nodiscard]] PALPATE_EXPORT std::filesystem::path surfaceFileOf(const std::filesystem::path& path);

/// Checks that a surface file may be written. The user names only the file of the path, so this file must be new or an
/// older export.
/// @return BadCommandLine if a different file exists
[[nodiscard]] PALPATE_EXPORT core::Status checkSurfaceFile(const std::filesystem::path& surface);

/// Serializes all measures as one JSON document, see docs/measures.md.
[[nodiscard]] PALPATE_EXPORT std::string measuresJson(const session::SessionMeasures& measures);
/// Returns the content of this document.
[[nodiscard]] PALPATE_EXPORT QJsonObject measuresObject(const session::SessionMeasures& measures);
/// Serializes the sums in the form shared by all JSON output.
[[nodiscard]] PALPATE_EXPORT QJsonObject sumsJson(const session::Measures& sums);

} // namespace palpate::study
