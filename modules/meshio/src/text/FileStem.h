// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace palpate::meshio::internal {

/// @return the name of a file without `.gz` and the extension, and without `.seg` of 3D Slicer and `.surf` of GIFTI:
/// "case" for "case.nii.gz" and "case.seg.nrrd"
[[nodiscard]] std::string fileStem(const std::filesystem::path& path);

/// @return true for placeholder names that programs write for unnamed parts; the name of the file says more
[[nodiscard]] bool isPlaceholder(std::string_view name);

} // namespace palpate::meshio::internal
