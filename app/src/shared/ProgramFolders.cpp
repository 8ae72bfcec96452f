// SPDX-License-Identifier: BSD-3-Clause
#include "shared/ProgramFolders.h"

#include <cstdlib>
#include <utility>
#include <vector>

namespace palpate::app {

namespace {

/// Finds a folder.
/// @param installed  relative to the program's folder; @param inTree  relative to a folder around the build
/// @param mark  file that the folder must contain; @param first  folders to try first
std::optional<std::filesystem::path> find(const char* installed, const char* inTree, const char* mark,
                                          std::vector<std::filesystem::path> first = {})
{
    std::error_code error;
    std::vector<std::filesystem::path> candidates = std::move(first);
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    candidates.push_back(program / installed);
    for (std::filesystem::path up = program; up.has_relative_path(); up = up.parent_path()) {
        candidates.push_back(up / inTree);
    }
    for (const std::filesystem::path& folder : candidates) {
        if (std::filesystem::exists(folder / mark, error)) {
            return std::filesystem::weakly_canonical(folder, error);
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<std::filesystem::path> phantomFolder()
{
    std::vector<std::filesystem::path> named;
    if (const char* data = std::getenv("PALPATE_DATA_DIR")) {
        named.emplace_back(std::filesystem::path(data) / "phantom");
    }
    return find("../share/palpate/phantom", "data/phantom", "phantom.palpate.json", std::move(named));
}

bool isSampleFile(const std::filesystem::path& file)
{
    const auto folder = phantomFolder();
    std::error_code error;
    return folder && std::filesystem::equivalent(file.parent_path(), *folder, error);
}

std::optional<std::filesystem::path> docsFolder()
{
    return find("../share/palpate/docs", "resources/docs", "window.md");
}

} // namespace palpate::app
