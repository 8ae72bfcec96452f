// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Finding.h>
#include <palpate/core/Status.h>
#include <palpate/session/RecordingReader.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace palpate::study {

// Findings for other programs: a table as CSV, and point lists as 3D Slicer reads and writes them (*.mrk.json, schema
// 1.0.3). Columns and rules: resources/docs/findings.md.

/// The columns of `findingsCsv`.
inline constexpr const char* kFindingColumns =
    "id,name,type,structure,x_mm,y_mm,z_mm,frame,size_mm,force_N,depth_mm,felt_N_per_mm,marked_s,recording,note,inside,"
    "total_force_N";

/// @return the organ that the structure of a finding lies in: the outermost layer that was touched, where that is
/// another one; empty where there is none.
[[nodiscard]] std::string organOf(const core::Finding& finding);

/// @return a table after RFC 4180 in UTF-8, a row a finding, the head first. Numbers give the same doubles back; a text
/// that a spreadsheet would compute gets a `'` before it.
[[nodiscard]] std::string findingsCsv(const std::vector<core::Finding>& findings);

/// @return one list of points a type, in LPS and mm. What a list cannot say stands in each point's field `palpate`, so
/// that `readMarkups` gives equal findings back; where it was recorded is left out.
[[nodiscard]] std::string findingsMarkups(const std::vector<core::Finding>& findings);

/// What a file of markups holds.
struct Markups
{
    std::vector<core::Finding> findings;
    std::vector<std::string> losses; ///< what was left out or shortened, one line a cause, with the first place
};

/// More points of one file are left out.
inline constexpr std::size_t kMostMarkups = 10000;

/// Reads the point lists of a file of markups: RAS is turned to LPS, µm become mm; a list that is called like a type
/// gives it.
/// @return Unreadable or BadFormat when it is no such file, or larger than 64 MiB
[[nodiscard]] core::Result<Markups> readMarkups(const std::filesystem::path& path);

/// The findings that a recording ends with, each with its moment there.
[[nodiscard]] std::vector<core::Finding> recordedFindings(const session::RecordingReader& reader);

} // namespace palpate::study
