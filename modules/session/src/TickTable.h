// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Database.h"

#include <palpate/servo/TickRecord.h>

#include <cstddef>
#include <string>

namespace palpate::session::internal {

// The table `ticks` and the view `tick_values`, as TickColumns.h lists their columns.

/// Makes the table. Its columns have no declared type on purpose: a column declared REAL keeps whole numbers as
/// integers and so loses the sign of a zero.
[[nodiscard]] std::string createTicks();
/// Makes the view, which has every value filled in.
[[nodiscard]] std::string createTickValues();
[[nodiscard]] std::string insertTick();
/// All columns, for `readTick`. @param rest  what follows "FROM ticks"
[[nodiscard]] std::string selectTicks(const std::string& rest);
/// How many columns the table has.
[[nodiscard]] std::size_t tickColumnCount();

/// Gives a tick's values to the statement `insertTick`.
void bindTick(Statement& row, const servo::TickRecord& tick);
/// Takes a tick from a row of `selectTicks`. What is not stored is as in a new TickRecord, but for the contact's
/// direction: that is the spring's.
[[nodiscard]] servo::TickRecord readTick(const Statement& row);

} // namespace palpate::session::internal
