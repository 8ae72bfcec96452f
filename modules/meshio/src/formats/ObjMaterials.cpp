// SPDX-License-Identifier: BSD-3-Clause
#include "formats/ObjMaterials.h"

#include "guard/FileImage.h"
#include "text/Encoding.h"
#include "text/TextScan.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace palpate::meshio::internal {

Materials parseMaterials(std::string_view text)
{
    constexpr std::size_t kLongestMaterialName = 256;
    Materials materials;
    std::optional<std::string> material; // empty before the first "newmtl"
    LineReader lines(withoutPadding(text.starts_with("\xef\xbb\xbf") ? text.substr(3) : text));
    while (lines.next()) {
        std::string_view rest = lines.line();
        const std::string_view word = takeWord(rest);
        if (sameWord(word, "newmtl")) {
            material = trimmed(rest.substr(0, kLongestMaterialName));
            (void)materials[*material];
        } else if ((word == "d" || word == "Tr") && material) {
            const std::optional<double> value = wordToNumber(takeWord(rest));
            const double opacity = word == "d" ? value.value_or(1.0) : 1.0 - value.value_or(0.0);
            if (opacity > 0.0 && opacity <= 1.0) {
                materials[*material].opacity = opacity;
            }
        } else if (word == "Kd" && material) {
            std::array<double, 3> colour = {};
            bool isColour = true;
            for (double& component : colour) {
                const std::optional<double> value = wordToNumber(takeWord(rest));
                isColour = isColour && value && *value >= 0.0 && *value <= 1.0;
                component = value.value_or(0.0);
            }
            if (isColour) {
                materials[*material].colour = colour;
            }
        }
    }
    return materials;
}

Materials readMaterials(const std::filesystem::path& folder, std::string_view name)
{
    constexpr std::size_t kMostBytes = std::size_t{4} << 20U;
    // Exporters on Windows write backslashes, and often the folder on the computer of the author.
    const std::size_t slash = name.find_last_of("/\\");
    name = trimmed(slash == std::string_view::npos ? name : name.substr(slash + 1));
    if (folder.empty() || name.empty() || name == "." || name == "..") {
        return {};
    }
    const core::Result<OpenFile> file = openFile(folder / std::filesystem::path(name));
    if (!file.isOk() || file.value().size > kMostBytes) {
        return {};
    }
    const core::Result<FileImage> image = FileImage::load(file.value(), name);
    if (!image.isOk()) {
        return {};
    }
    const std::optional<std::string> converted = fromUtf16(image.value().bytes());
    return parseMaterials(converted ? std::string_view(*converted) : image.value().bytes());
}

} // namespace palpate::meshio::internal
