// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::meshio {

/// @return the endings of the files that `readMesh` reads, in lower case, ".stl" first. The content decides what a file
///         is; these are for file dialogs and folders.
[[nodiscard]] std::vector<std::string> meshExtensions();

/// @return true for one of `meshExtensions`, in upper or lower case.
[[nodiscard]] bool hasMeshExtension(const std::filesystem::path& path);

/// @param conjunction  before the last one
/// @return the formats' names, for a sentence: "STL, VTP and OBJ"
[[nodiscard]] std::string meshFormatNames(std::string_view conjunction);

} // namespace palpate::meshio
