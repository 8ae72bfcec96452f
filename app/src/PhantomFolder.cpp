// SPDX-License-Identifier: BSD-3-Clause
#include "PhantomFolder.h"

#include <cstdlib>
#include <vector>

namespace palpate::app {

std::optional<std::filesystem::path> phantomFolder()
{
    std::error_code error;
    std::vector<std::filesystem::path> candidates;
    if (const char* named = std::getenv("PALPATE_DATA_DIR")) {
        candidates.emplace_back(std::filesystem::path(named) / "phantom");
    }
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    candidates.push_back(program / "../share/palpate/phantom");
    // In a build tree: the source's data folder is a few folders up.
    for (std::filesystem::path up = program; up.has_relative_path(); up = up.parent_path()) {
        candidates.push_back(up / "data/phantom");
    }
    for (const std::filesystem::path& folder : candidates) {
        if (std::filesystem::exists(folder / "phantom.palpate.json", error)) {
            return std::filesystem::weakly_canonical(folder, error);
        }
    }
    return std::nullopt;
}

} // namespace palpate::app
