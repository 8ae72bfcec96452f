// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace palpate::meshio {

/// Lists the mesh files of a folder and of the folders directly in it, sorted by path; the files of the folder itself
/// come first. Names that begin with a dot are skipped: hidden files, and the AppleDouble files of macOS
/// ("._liver.stl").
/// @param error  set when the folder cannot be read
[[nodiscard]] std::vector<std::filesystem::path> meshFilesIn(const std::filesystem::path& folder,
                                                             std::error_code& error);

/// Finds the prefix that programs put before the name of each structure, such as 3D Slicer's "Segmentation_" in
/// "Segmentation_liver.stl" and "Segmentation_spleen.stl".
/// @param names  of files without extensions
/// @return the longest common prefix that ends in "_"; empty for fewer than two names, and if the prefix names anatomy
/// ("lung_" of "lung_left" and "lung_right")
[[nodiscard]] PALPATE_EXPORT std::string commonPrefix(const std::vector<std::string>& names);

} // namespace palpate::meshio
