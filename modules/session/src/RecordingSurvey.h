// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CheckedLines.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace palpate::session::internal {

/// Which parts of a recording are, bit for bit, what was written.
struct Survey
{
    std::vector<Check> blocks;         ///< of ticks that are as written, ascending
    CheckedLines::Covered covered;     ///< of scenes and events
    std::vector<std::string> embedded; ///< hashes of those that are
    std::vector<std::string> faults;   ///< what is not, one line each that names it; empty: all is
};

/// Holds every checksum of a recording against its tables.
/// @param meta  as read; what is missing in it makes the metadata a fault
/// @par Cost About 4 µs a tick.
[[nodiscard]] Survey survey(const RecordingTables& tables, const MetaTable& meta);

} // namespace palpate::session::internal
