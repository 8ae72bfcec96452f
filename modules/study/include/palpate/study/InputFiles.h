// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <filesystem>
#include <vector>

namespace palpate::study {

/// Returns an input and all dependencies, whether they exist or not: meshes and maps of a scene file, mesh files of a
/// folder, scene and meshes of a recording. An unreadable input has no dependencies.
[[nodiscard]] PALPATE_EXPORT std::vector<std::filesystem::path> filesOf(const std::filesystem::path& input);

} // namespace palpate::study
