// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace palpate::test {

/// Recomputes every checksum of a recording, as any program can.
/// @return false if reading or writing the recording fails
bool rehash(const std::filesystem::path& recording);

/// Recomputes hash and all_sha256 of the embedded surfaces and updates the references in the structures.
bool rehashSurfaces(const std::filesystem::path& recording);

/// Returns the rollback journal of a transaction over several databases, without a page: after the rollback SQLite
/// deletes the file named in the journal.
[[nodiscard]] std::string superJournal(const std::filesystem::path& recording, const std::string& name);

/// Writes a recording of the box of 40 mm with an embedded surface, a note and a finding.
/// @param ticks  as in palpationTicks
bool writeRichRecording(const std::filesystem::path& recording, int ticks);

} // namespace palpate::test
