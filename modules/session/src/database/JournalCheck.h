// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <filesystem>

namespace palpate::session::internal {

/// Checks a journal that a crash may have left next to a database, before SQLite opens both.
/// @return BadFormat for a link, pipe or device, and for a journal of a multi-file transaction. Rolling back the latter
///         deletes an arbitrary file named in the journal. Palpate never writes such a journal.
/// @par Source https://www.sqlite.org/atomiccommit.html, section 5 (multi-file commit)
[[nodiscard]] core::Status checkJournal(const std::filesystem::path& database);

} // namespace palpate::session::internal
