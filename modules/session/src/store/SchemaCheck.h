// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "database/Database.h"

namespace palpate::session::internal {

/// Compares a database's schema with the tables of a recording version. Requires exactly the columns of that version,
/// all stored, and rejects other views than Palpate's own `tick_values`, triggers, virtual tables, and indices other
/// than automatic ones. As a result, a reader's statements never run code from the file.
/// @param version  1 to kMovingVersion
/// @return BadFormat without the file name for the first missing or unexpected item
[[nodiscard]] core::Status checkSchema(const Database& database, int version);

} // namespace palpate::session::internal
