// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "database/Database.h"
#include "palpate/session/Recording.h"

#include <palpate/servo/TickRecord.h>

#include <cstddef>
#include <string>
#include <vector>

namespace palpate::session::internal {

// Table `ticks` and view `tick_values` with the columns of TickColumns.h. `version` is that of the recording.

/// Returns the SQL for the table. Columns deliberately have no declared type: a REAL column stores whole numbers as
/// integers and thus loses the sign of zero.
[[nodiscard]] std::string createTicks(int version = kRecordingVersion);
/// Returns the SQL for the view, which resolves all NULLs except normals and layers: sqrt() is not available in every
/// SQLite build.
[[nodiscard]] std::string createTickValues(int version);
/// Returns all definitions of the view that Palpate has written for a recording version.
[[nodiscard]] std::vector<std::string> knownTickValues(int version);
[[nodiscard]] std::string insertTick();
/// Selects all columns for `readTick`. @param rest  text after "FROM ticks"
[[nodiscard]] std::string selectTicks(const std::string& rest, int version);
/// Returns the number of columns of the table.
[[nodiscard]] std::size_t tickColumnCount(int version = kRecordingVersion);

/// Binds a tick's values to the statement `insertTick`.
void bindTick(Statement& row, const servo::TickRecord& tick);
/// Reads a tick from a row of `selectTicks`. Values that are not stored keep their defaults. Before version 3, the
/// contact normal is the spring direction, and the reported layer is the only contact.
/// @param wrong  set to the fault if a value has a wrong type or exceeds Bounds.h: "found text for hip_x, expected a
///               number"; the value is then zero
[[nodiscard]] servo::TickRecord readTick(const Statement& row, int version, core::Message& wrong);

} // namespace palpate::session::internal
