// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace palpate::meshio::internal {

/// Look of a material.
struct Material
{
    std::optional<std::array<double, 3>> colour{}; ///< diffuse colour (`Kd`): red, green, blue in 0 … 1
    /// `d`, or 1 less `Tr`; more than 0, because some programs write 0 for an opaque material.
    double opacity = 1.0;
};

/// Materials of a library by name.
using Materials = std::map<std::string, Material, std::less<>>;

/// Reads colours and opacities of a Wavefront material library (.mtl). Invalid lines are skipped.
[[nodiscard]] Materials parseMaterials(std::string_view text);

/// Reads the material library of an OBJ file. Only a file in the OBJ's own folder is read, of at most 4 MiB.
/// @param name  as in the line `mtllib`, with or without folders
/// @return empty when the library cannot be read
[[nodiscard]] Materials readMaterials(const std::filesystem::path& folder, std::string_view name);

} // namespace palpate::meshio::internal
