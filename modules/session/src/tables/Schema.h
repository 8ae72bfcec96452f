// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/Recording.h"
#include "tables/TickTable.h"

#include <palpate/core/Tissue.h>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace palpate::session::internal {

/// Returns the tissue parameters stored by recordings of a version. @param version  1 to kMovingVersion
inline std::span<const core::TissueTerm> tissueTerms(int version)
{
    constexpr std::array<std::size_t, kMovingVersion + 1> kTerms{0, 2, 2, 5, 5, 5}; // number of terms by version
    static_assert(kTerms.back() == core::kTissueTerms.size(), "another term, another version");
    return std::span(core::kTissueTerms).first(kTerms[static_cast<std::size_t>(version)]);
}

/// Returns the tissue columns of the table `structures`, each with a leading comma. @param type  SQL type of each
inline std::string tissueColumns(int version, std::string_view type = "")
{
    std::string columns;
    for (const core::TissueTerm& term : tissueTerms(version)) {
        columns.append(", ").append(term.key).append(type);
    }
    return columns;
}

/// Returns numbered placeholders for these columns, each with a leading comma. @param first  first number
inline std::string tissuePlaces(std::size_t first)
{
    std::string places;
    for (std::size_t i = 0; i < core::kTissueTerms.size(); ++i) {
        places.append(", ?").append(std::to_string(first + i));
    }
    return places;
}

inline constexpr int kMapsSince = 3; ///< version that introduced the table of maps

/// Returns the SQL for the tables of resources/docs/recording.md. @param version  1 to kMovingVersion
inline std::string schema(int version = kRecordingVersion)
{
    const bool hasChecksOfAll = version >= 2; // version 1 has checksums for ticks only and no embedded surfaces
    return "CREATE TABLE meta(key TEXT PRIMARY KEY, value) WITHOUT ROWID;\n" + createTicks(version) + R"sql(
CREATE TABLE scenes(generation INTEGER PRIMARY KEY, structures INTEGER NOT NULL)sql" +
           (hasChecksOfAll ? ", fingertip_mm REAL NOT NULL" : "") + R"sql();
CREATE TABLE meshes(mesh INTEGER PRIMARY KEY, path TEXT, part TEXT, unit_mm REAL, flipped INTEGER, pose TEXT,
  sha256 TEXT, UNIQUE(path, part, unit_mm, flipped, pose, sha256));
CREATE TABLE structures(generation INTEGER, number INTEGER, name TEXT, mesh INTEGER REFERENCES meshes(mesh))sql" +
           tissueColumns(version, " REAL") + ", layer INTEGER, palpable INTEGER" +
           (version >= 3 ? ", law TEXT, law_table BLOB, maps TEXT" : "") + R"sql(,
  PRIMARY KEY(generation, number)) WITHOUT ROWID;
CREATE TABLE events(id INTEGER PRIMARY KEY, tick INTEGER NOT NULL, kind TEXT NOT NULL, json TEXT NOT NULL);
)sql" +
           (hasChecksOfAll ? R"sql(
CREATE TABLE checks(id INTEGER PRIMARY KEY, kind TEXT NOT NULL, first INTEGER, last INTEGER, rows INTEGER NOT NULL,
  sha256 BLOB NOT NULL);
CREATE TABLE embedded(sha256 TEXT PRIMARY KEY, vertices BLOB NOT NULL, triangles BLOB NOT NULL,
  two_sided BLOB NOT NULL, source BLOB NOT NULL, all_sha256 BLOB NOT NULL);
)sql"
                           : R"sql(
CREATE TABLE checks(first_tick INTEGER PRIMARY KEY, last_tick INTEGER NOT NULL, ticks INTEGER NOT NULL,
  sha256 BLOB NOT NULL);
)sql") + createTickValues(version);
}

/// Creates the table of map values, which exists only in recordings with maps.
inline constexpr const char* kCreateMaps =
    "CREATE TABLE IF NOT EXISTS maps(id INTEGER PRIMARY KEY, sha256 TEXT UNIQUE, corners BLOB NOT NULL)";

/// Values of the column `kind` in `checks`.
inline constexpr const char* kMetaCheck = "meta";
inline constexpr const char* kSceneCheck = "scene";
inline constexpr const char* kEventsCheck = "events";
inline constexpr const char* kTicksCheck = "ticks";

inline constexpr const char* kInsertCheck = "INSERT INTO checks(kind, first, last, rows, sha256) VALUES(?, ?, ?, ?, ?)";

} // namespace palpate::session::internal
