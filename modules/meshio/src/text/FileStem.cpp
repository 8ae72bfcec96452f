// SPDX-License-Identifier: BSD-3-Clause
#include "text/FileStem.h"

#include "text/TextScan.h"

#include <algorithm>
#include <array>
#include <cstddef>
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

bool isPlaceholder(std::string_view name)
{
    static constexpr std::array<std::string_view, 12> kBegins{"default", "mesh",   "object",  "group",
                                                              "solid",   "ascii",  "unnamed", "untitled",
                                                              "model",   "noname", "no_name", "polydata"};
    constexpr std::size_t kLongest = 80;
    return name.empty() || name.size() > kLongest || (name.front() >= '0' && name.front() <= '9') ||
           name.find("SPACE=") != std::string_view::npos ||
           std::any_of(kBegins.begin(), kBegins.end(), [&](std::string_view begin) {
               return name.size() >= begin.size() && sameWord(name.substr(0, begin.size()), begin);
           });
}

} // namespace palpate::meshio::internal
