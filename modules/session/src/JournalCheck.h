// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <filesystem>

namespace palpate::session::internal {

/// Looks at the journal that a crash may have left beside a database, before SQLite does.
/// @return BadFormat for one that is a link, a pipe or a device, and for the journal of several databases: rolling that
///         back deletes a file of any name, which the journal holds. Palpate never writes one.
/// @par Source https://www.sqlite.org/atomiccommit.html, section 5 (multi-file commit)
[[nodiscard]] core::Status checkJournal(const std::filesystem::path& database);

} // namespace palpate::session::internal
