// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Finding.h>
#include <palpate/core/Message.h>
#include <palpate/core/Status.h>
#include <palpate/session/RecordingReader.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace palpate::study {

// Exchange of findings with other programs: CSV tables and 3D Slicer point lists (*.mrk.json, schema 1.0.3). Columns
// and rules: docs/findings.md.

/// Columns of `findingsCsv`.
inline constexpr const char* kFindingColumns =
    "id,name,type,structure,x_mm,y_mm,z_mm,frame,size_mm,force_N,depth_mm,felt_N_per_mm,marked_s,recording,note,inside,"
    "total_force_N";

/// Returns the organ around the structure of a finding: the outermost touched layer if different from that structure,
/// else empty.
[[nodiscard]] PALPATE_EXPORT std::string organOf(const core::Finding& finding);

/// Writes a table according to RFC 4180 in UTF-8 with a header and one row per finding. Numbers read back bit-exactly.
/// A text that a spreadsheet would evaluate as a formula gets a leading `'`.
[[nodiscard]] PALPATE_EXPORT std::string findingsCsv(const std::vector<core::Finding>& findings);

/// Returns the row of `findingsCsv` for one finding, without the line end. @param number  id of a finding without an id
[[nodiscard]] PALPATE_EXPORT std::string findingRow(const core::Finding& finding, std::size_t number);

/// Writes one point list per type, in LPS and mm. Fields without an equivalent in a point list are stored in the
/// point's field `palpate`, so that `readMarkups` restores equal findings, except for the place of recording.
[[nodiscard]] PALPATE_EXPORT std::string findingsMarkups(const std::vector<core::Finding>& findings);

/// Content of a markups file.
struct Markups
{
    std::vector<core::Finding> findings;
    std::vector<core::Message> losses; ///< omitted or shortened data, one line per cause with the first location
};

/// Maximum number of points read from a file; the rest is skipped.
inline constexpr std::size_t kMaxMarkups = 10000;

/// Reads the point lists and lines of a markups file. Converts RAS to LPS and µm to mm. A list with the name of a
/// finding type assigns that type. A line becomes a finding in its middle, with its length as the size.
/// @return Unreadable or BadFormat if the file is not a markups file or larger than 64 MiB
[[nodiscard]] PALPATE_EXPORT core::Result<Markups> readMarkups(const std::filesystem::path& path);

/// Returns the findings at the end of a recording, each with the time of marking.
[[nodiscard]] PALPATE_EXPORT std::vector<core::Finding> recordedFindings(const session::RecordingReader& reader);

} // namespace palpate::study
