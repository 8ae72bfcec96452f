// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>
#include <palpate/session/RecordingReader.h>

#include <filesystem>

namespace palpate::app {

/// Writes the ticks of a recording as TICKS.csv.
[[nodiscard]] core::Status exportTicks(const session::RecordingReader& reader, const std::filesystem::path& path);

/// @return where the touched surface goes when the path goes to `path`: "P.vtp" gives "P-surface.vtp".
[[nodiscard]] std::filesystem::path surfaceFileOf(const std::filesystem::path& path);

} // namespace palpate::app
