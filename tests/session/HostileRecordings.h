// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace palpate::test {

/// Makes every checksum of a recording right again, as any program can that writes one.
/// @return false when the recording cannot be read or written
bool rehash(const std::filesystem::path& recording);

/// Makes hash and all_sha256 of the embedded surfaces right again, and the structures refer to them.
bool rehashSurfaces(const std::filesystem::path& recording);

/// The rollback journal of a transaction over several databases, without a page: SQLite deletes the file that it names
/// once it has rolled it back.
[[nodiscard]] std::string superJournal(const std::filesystem::path& recording, const std::string& name);

/// A recording of the box of 40 mm with an embedded surface, a note and a finding.
/// @param ticks  as in palpationTicks
bool writeRichRecording(const std::filesystem::path& recording, int ticks);

} // namespace palpate::test
