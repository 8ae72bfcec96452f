// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace palpate::session {

/// What came out of a damaged or cut-off recording.
struct Recovery
{
    std::int64_t ticks = 0;          ///< in the copy
    std::vector<std::string> losses; ///< what is missing in it, one line each; empty: nothing is
};

/// Makes the best readable copy of a recording: everything whose checksum holds, and what is readable where the
/// checksum itself is gone. What is known to differ from what was written is left out and named.
/// @param from  only read; a journal that a crash left beside it is taken into account
/// @param to    a file or link of this name is replaced once the copy is whole; one that another program is recording
///              into is refused
/// @return one line when not even the metadata's table can be read, or `to` cannot be written
[[nodiscard]] core::Result<Recovery> recoverRecording(const std::filesystem::path& from,
                                                      const std::filesystem::path& to);

} // namespace palpate::session
