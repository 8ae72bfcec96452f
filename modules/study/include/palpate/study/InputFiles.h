// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace palpate::study {

/// @return an input and the files that belong to it, whether they are there or not: meshes and maps of a scene file,
/// mesh files of a folder, scene and meshes of a recording. What cannot be read belongs to itself alone.
[[nodiscard]] std::vector<std::filesystem::path> filesOf(const std::filesystem::path& input);

} // namespace palpate::study
