// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <cstdint>
#include <filesystem>

namespace palpate::session::internal {

/// What was found in the pages of a damaged database.
struct Salvage
{
    std::int64_t pages = 0; ///< whole ones in the file
    std::int64_t rows = 0;  ///< that have the form of a recording's
    std::int64_t ticks = 0; ///< of them
};

/// Gathers a recording's rows from the pages of a database file one by one, without the header, the schema and the
/// inner pages that lead to them, and puts them into a new database. What a row says is not judged here: its checksum
/// does that. Rows that lie in another file's page size are not found, nor are those of version 1's checksums.
/// @param from  any file; what it says is not trusted
/// @param to    made anew, with the tables of this version
/// @par Source https://www.sqlite.org/fileformat2.html, sections 1.6 (b-tree pages) and 2.1 (records).
[[nodiscard]] core::Result<Salvage> salvagePages(const std::filesystem::path& from, const std::filesystem::path& to);

} // namespace palpate::session::internal
