// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Database.h"

namespace palpate::session::internal {

/// Holds a database's schema against the tables that recordings of a version have: each is a table with the columns
/// of its version, all of them stored; there is no view but `tick_values` with Palpate's own text, no trigger, no
/// virtual table and no index but SQLite's own. So that no statement of a reader runs what a file brings along.
/// @param version  1 to kRecordingVersion
/// @return BadFormat without the file's name for the first thing that is missing or another one
[[nodiscard]] core::Status checkSchema(const Database& database, int version);

} // namespace palpate::session::internal
