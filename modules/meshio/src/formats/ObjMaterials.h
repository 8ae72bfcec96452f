// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace palpate::meshio::internal {

/// Diffuse colours of the materials in a library, by name: red, green, blue in 0 … 1.
using MaterialColours = std::map<std::string, std::array<double, 3>, std::less<>>;

/// Reads the colours (`Kd`) of a Wavefront material library (.mtl). Invalid lines are skipped.
[[nodiscard]] MaterialColours parseMaterials(std::string_view text);

/// Reads the material library of an OBJ file. Only a file in the OBJ's own folder is read, of at most 4 MiB.
/// @param name  as in the line `mtllib`, with or without folders
/// @return empty when the library cannot be read
[[nodiscard]] MaterialColours readMaterials(const std::filesystem::path& folder, std::string_view name);

} // namespace palpate::meshio::internal
