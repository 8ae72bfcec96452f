// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>

namespace palpate::app {

/// Folder of the bundled phantom: beside the installed program, in the source tree, or in PALPATE_DATA_DIR.
[[nodiscard]] std::optional<std::filesystem::path> phantomFolder();

/// Returns whether a file is in the folder of the bundled phantom, where nothing is saved.
[[nodiscard]] bool isSampleFile(const std::filesystem::path& file);

/// Folder of the documents: installed beside the program, otherwise in the source tree around the build.
[[nodiscard]] std::optional<std::filesystem::path> docsFolder();

} // namespace palpate::app
