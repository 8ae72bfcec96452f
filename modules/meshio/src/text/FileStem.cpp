// SPDX-License-Identifier: BSD-3-Clause
#include "text/FileStem.h"

#include "text/TextScan.h"

#include <string_view>

namespace palpate::meshio::internal {

std::string fileStem(const std::filesystem::path& path)
{
    const auto hasEnding = [](const std::filesystem::path& name, std::string_view ending) {
        return sameWord(name.extension().string(), ending);
    };
    std::filesystem::path name = path.filename();
    name = hasEnding(name, ".gz") ? name.stem() : name;
    const std::filesystem::path stem = name.stem();
    const bool isInner = (hasEnding(stem, ".seg") && (hasEnding(name, ".nrrd") || hasEnding(name, ".nhdr"))) ||
                         (hasEnding(stem, ".surf") && hasEnding(name, ".gii"));
    return (isInner ? stem.stem() : stem).string();
}

} // namespace palpate::meshio::internal
