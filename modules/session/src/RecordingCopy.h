// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Scratch.h>
#include <palpate/core/Status.h>

#include <filesystem>
#include <string>

namespace palpate::session::internal {

/// Copies a recording and the rollback journal that a crash left beside it (the file's name and "-journal"): as many
/// bytes as SQLite's header counts pages, with the holes of the file left as holes, after a look at the free space.
/// @param to      a folder without a file called `name`
/// @param output  that is made from the copy, for messages: NoSpace when there is no room for it
/// @par Source https://www.sqlite.org/fileformat2.html, sections 1.3 (header) and 3 (rollback journal).
[[nodiscard]] core::Status copyRecording(const std::filesystem::path& from, const core::Scratch& to,
                                         const std::string& name, const std::filesystem::path& output);

} // namespace palpate::session::internal
