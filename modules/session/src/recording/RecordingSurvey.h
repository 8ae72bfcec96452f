// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "store/CheckedLines.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace palpate::session::internal {

/// Verification result of a recording.
struct Survey
{
    std::vector<Check> blocks;         ///< intact blocks of ticks, ascending
    CheckedLines::Covered covered;     ///< for scenes and events
    std::vector<std::size_t> known;    ///< see CheckedLines::known
    std::vector<std::string> embedded; ///< hashes of the intact surfaces
    std::vector<core::Message> faults; ///< one line per damaged part; empty if the recording is intact
};

/// Verifies all checksums of a recording.
/// @param meta  as read; missing entries are reported as damaged metadata
/// @param progress  progress callback (0 to 1). Return false to cancel: the result is then incomplete. May be empty
/// @par Cost About 4 µs per tick.
[[nodiscard]] Survey survey(const RecordingTables& tables, const MetaTable& meta,
                            const std::function<bool(double)>& progress = {});

} // namespace palpate::session::internal
