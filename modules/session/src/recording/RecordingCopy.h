// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Scratch.h>
#include <palpate/core/Status.h>

#include <filesystem>
#include <string>

namespace palpate::session::internal {

/// Copies a recording and the rollback journal left by a crash (file name plus "-journal"). Checks the free space,
/// copies only the pages counted in the SQLite header and preserves holes of sparse files.
/// @param to  folder without a file called `name`
/// @param output  final file made from the copy, for messages: NoSpace if the disk is too small
/// @par Source https://www.sqlite.org/fileformat2.html, sections 1.3 (header) and 3 (rollback journal).
[[nodiscard]] core::Status copyRecording(const std::filesystem::path& from, const core::Scratch& to,
                                         const std::string& name, const std::filesystem::path& output);

} // namespace palpate::session::internal
