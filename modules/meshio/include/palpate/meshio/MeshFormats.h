// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::meshio {

/// @return the extensions of readable mesh files in lower case, ".stl" first. For file dialogs and folders; the format
/// is
///         detected from the content.
[[nodiscard]] PALPATE_EXPORT std::vector<std::string> meshExtensions();

/// @return true for one of `meshExtensions`, in upper or lower case.
[[nodiscard]] PALPATE_EXPORT bool hasMeshExtension(const std::filesystem::path& path);

/// @return true for the extensions of volumes among them, which are opened as label maps.
[[nodiscard]] PALPATE_EXPORT bool hasLabelMapExtension(const std::filesystem::path& path);

/// @param conjunction  before the last name
/// @return the format names as a list: "STL, VTP and OBJ"
[[nodiscard]] PALPATE_EXPORT std::string meshFormatNames(std::string_view conjunction);

} // namespace palpate::meshio
