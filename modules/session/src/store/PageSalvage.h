// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <cstdint>
#include <filesystem>

namespace palpate::session::internal {

/// Statistics about the pages of a damaged database.
struct Salvage
{
    std::int64_t pages = 0; ///< complete pages in the file
    std::int64_t rows = 0;  ///< rows with the form of a recording row
    std::int64_t ticks = 0; ///< ticks among these rows
};

/// Collects the rows of a recording directly from the pages of a database file, without the header, the schema and the
/// inner pages, and inserts them into a new database. Does not validate the content; the checksums do. Does not find
/// rows in pages of a different size, nor the checksums of version 1.
/// @param from  any untrusted file
/// @param to  newly created, with the tables of this version
/// @par Source https://www.sqlite.org/fileformat2.html, sections 1.6 (b-tree pages) and 2.1 (records).
[[nodiscard]] core::Result<Salvage> salvagePages(const std::filesystem::path& from, const std::filesystem::path& to);

} // namespace palpate::session::internal
