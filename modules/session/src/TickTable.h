// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Database.h"
#include "palpate/session/Recording.h"

#include <palpate/servo/TickRecord.h>

#include <cstddef>
#include <string>
#include <vector>

namespace palpate::session::internal {

// The table `ticks` and the view `tick_values`, as TickColumns.h lists their columns; `version` is the recording's.

/// Makes the table. Its columns have no declared type on purpose: a column declared REAL keeps whole numbers as
/// integers and so loses the sign of a zero.
[[nodiscard]] std::string createTicks(int version = kRecordingVersion);
/// Makes the view, which has every value filled in but normals and layers: not every SQLite can take a root.
[[nodiscard]] std::string createTickValues(int version);
/// The texts that Palpate has given the view in recordings of a version.
[[nodiscard]] std::vector<std::string> knownTickValues(int version);
[[nodiscard]] std::string insertTick();
/// All columns, for `readTick`. @param rest  what follows "FROM ticks"
[[nodiscard]] std::string selectTicks(const std::string& rest, int version);
/// How many columns the table has.
[[nodiscard]] std::size_t tickColumnCount(int version = kRecordingVersion);

/// Gives a tick's values to the statement `insertTick`.
void bindTick(Statement& row, const servo::TickRecord& tick);
/// Takes a tick from a row of `selectTicks`. What is not stored is as in a new TickRecord; before version 3 the
/// contact's normal is the direction of the spring, and the reported layer the only one.
/// @param wrong  set to what is wrong with the row where a value is of another type or beyond the bounds of Bounds.h:
///               "found text for hip_x, expected a number"; the tick then holds zeros there
[[nodiscard]] servo::TickRecord readTick(const Statement& row, int version, std::string& wrong);

} // namespace palpate::session::internal
