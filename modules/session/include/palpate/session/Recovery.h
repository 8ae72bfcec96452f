// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace palpate::session {

/// Result of the recovery of a damaged or incomplete recording.
struct Recovery
{
    std::int64_t ticks = 0;            ///< number of ticks in the copy
    std::vector<core::Message> losses; ///< missing data, one line each; empty: complete
};

/// Writes the best readable copy of a recording: all data with a valid checksum, and all readable data whose checksum
/// itself is lost. Data known to be damaged is omitted and listed in the result.
/// @param from  opened read-only; a journal left by a crash is applied
/// @param to  an existing file or link is replaced once the copy is complete, unless another program is recording into
///            it
/// @return a one-line error if the metadata table cannot be read or `to` cannot be written
[[nodiscard]] PALPATE_EXPORT core::Result<Recovery> recoverRecording(const std::filesystem::path& from,
                                                                     const std::filesystem::path& to);

} // namespace palpate::session
