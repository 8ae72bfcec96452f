// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/meshio/MeshFolder.h"

#include "palpate/meshio/AnatomyKind.h"
#include "palpate/meshio/MeshFormats.h"

#include <algorithm>
#include <cstddef>

namespace palpate::meshio {

namespace {

namespace fs = std::filesystem;

bool isHidden(const fs::path& path)
{
    return path.filename().string().starts_with('.');
}

/// Appends the mesh files of one folder, sorted, and collects the folders in it.
void addFilesOf(const fs::path& folder, std::vector<fs::path>& files, std::vector<fs::path>& folders,
                std::error_code& error)
{
    const auto begin = static_cast<std::ptrdiff_t>(files.size());
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        std::error_code unknown; // of this entry: a dangling link is not an error of the folder
        if (isHidden(entry->path())) {
            continue;
        }
        if (entry->is_directory(unknown)) {
            folders.push_back(entry->path());
        } else if (hasMeshExtension(entry->path()) && entry->is_regular_file(unknown)) {
            files.push_back(entry->path());
        }
    }
    std::sort(files.begin() + begin, files.end());
}

} // namespace

std::vector<fs::path> meshFilesIn(const fs::path& folder, std::error_code& error)
{
    std::vector<fs::path> files, folders, deeper;
    addFilesOf(folder, files, folders, error);
    std::sort(folders.begin(), folders.end());
    for (const fs::path& inner : folders) {
        std::error_code unreadable; // the other folders still open
        addFilesOf(inner, files, deeper, unreadable);
    }
    return files;
}

std::string commonPrefix(const std::vector<std::string>& names)
{
    if (names.size() < 2) {
        return {};
    }
    std::string prefix = names.front();
    for (const std::string& name : names) {
        const auto differs = std::mismatch(prefix.begin(), prefix.end(), name.begin(), name.end()).first;
        prefix.erase(differs, prefix.end());
    }
    prefix.erase(prefix.rfind('_') + 1); // npos + 1 is 0
    const bool isWhole = std::ranges::any_of(names, [&](const std::string& name) { return name == prefix; });
    return isWhole || anatomyKind(prefix) != AnatomyKind::Other ? std::string() : prefix;
}

} // namespace palpate::meshio
