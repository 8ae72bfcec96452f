// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>

namespace palpate::app {

/// The bundled phantom's folder: beside the installed program, in the source tree, or where PALPATE_DATA_DIR says.
[[nodiscard]] std::optional<std::filesystem::path> phantomFolder();

/// @return the folder with the documents: installed beside the program, else the one in the source tree around a build.
[[nodiscard]] std::optional<std::filesystem::path> docsFolder();

} // namespace palpate::app
