// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Message.h>
#include <palpate/session/MeasureSession.h>
#include <palpate/session/RecordingReader.h>

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::study {

// Tables of many sessions, for statistics: one row per session, structure and measure, and one row per finding. RFC
// 4180, UTF-8, lines end with CR LF. Columns and rules: docs/cohort.md.

/// Columns of `measureRows`.
inline constexpr const char* kMeasureColumns = "session,sha256,started_utc,device,structure,measure,value,unit";
/// Columns of `findingRows` before those of `findingsCsv`, and behind.
inline constexpr const char* kFindingSession = "session,sha256,started_utc,device";
inline constexpr const char* kFindingMeasures =
    "first_touched_s,dwell_s,visits,mean_force_N,peak_force_N,peak_depth_mm";

/// Recording named or found by the user.
struct NamedRecording
{
    std::filesystem::path path;
    std::string name; ///< of the session in the tables, unique among the recordings
};

struct FoundRecordings
{
    std::vector<NamedRecording> recordings;
    std::vector<core::Message> losses; ///< folders without a recording or that cannot be read, one line each
};

/// Finds the recordings of files and folders. Folders are searched with all folders below for `*.palpate`, sorted by
/// path; names that begin with a dot are skipped. A file that is named twice is taken once. The name of a session is
/// the path inside the folder given by the user, for a file the file name. If two sessions would have the same name,
/// both get as many of their folders as they need to differ.
[[nodiscard]] PALPATE_EXPORT FoundRecordings findRecordings(const std::vector<std::filesystem::path>& inputs);

/// Session of a row.
struct TableSession
{
    std::string name;
    std::string sha256; ///< of the file
    std::string startedUtc;
    std::string device; ///< id of the device
};

[[nodiscard]] PALPATE_EXPORT TableSession tableSession(const session::RecordingReader& reader, std::string name);

/// Returns the rows of a session: first those without a structure, then by structure. A measure is named as in
/// `measuresJson`; the names of phases are joined to `search_time_s` or `press_phases`. An unknown value is empty.
[[nodiscard]] PALPATE_EXPORT std::string measureRows(const TableSession& session,
                                                     const session::SessionMeasures& measures);

/// Returns one row per finding and note of a session. The measures of a note are empty.
/// @param file  recording, of which the rows contain the file name
[[nodiscard]] PALPATE_EXPORT std::string
findingRows(const TableSession& session, const session::SessionMeasures& measures, const std::filesystem::path& file);

} // namespace palpate::study
