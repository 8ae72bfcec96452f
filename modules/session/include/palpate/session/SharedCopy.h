// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>

#include <cstdint>
#include <filesystem>

namespace palpate::session {

/// Writes a copy of a recording without the names of folders, to give to others. The scene and the meshes are stored
/// by file name, and the absolute paths in the texts of events are reduced to the last name. Ticks, findings, tissue
/// and embedded surfaces are the same bit for bit. The checksums are computed again, and the event `shared` is added
/// with the SHA-256 of the original.
///
/// The copy is a new database, so that it has no freed pages or journal with older content.
/// @param from  opened read-only
/// @param to  an existing file or link is replaced once the copy is complete, unless another program is recording into
///            it
/// @return number of ticks; Mismatch for a damaged recording, which `recoverRecording` copies; BadCommandLine if both
///         are the same file
[[nodiscard]] PALPATE_EXPORT core::Result<std::int64_t> shareRecording(const std::filesystem::path& from,
                                                                       const std::filesystem::path& to);

} // namespace palpate::session
