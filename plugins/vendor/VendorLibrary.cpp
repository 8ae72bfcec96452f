// SPDX-License-Identifier: BSD-3-Clause
#include "VendorLibrary.h"

#include <algorithm>
#include <cstring>
#include <dlfcn.h>
#include <link.h>
#include <system_error>
#include <utility>

namespace palpate::vendor {

using core::Status;
using core::StatusCode;
using std::filesystem::path;

namespace {

constexpr int kDeepestFolder = 4; // SDKs keep libraries in folders such as lib/release/lin-x86_64-gcc

std::string loaderError()
{
    const char* const error = dlerror();
    return error == nullptr ? "" : error;
}

/// All symbols are resolved at once, so that a library whose own dependencies are missing fails here and not later in
/// the I/O thread.
void* load(const char* name)
{
    return dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
}

/// Appends the files in `folder` that are named `soname` or have a longer version.
/// @param depth  levels of subfolders to search as well
void addFiles(const std::string& soname, const path& folder, int depth, std::vector<path>& found)
{
    std::error_code error;
    for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        const std::string name = it->path().filename().string();
        std::error_code ignored;
        if (name == soname || name.starts_with(soname + '.')) {
            found.push_back(it->path());
        } else if (depth > 0 && it->is_directory(ignored) && !it->is_symlink(ignored)) {
            addFiles(soname, it->path(), depth - 1, found);
        }
    }
}

/// Returns the files of all folders and trees: exact names first, then longer names, the newest version first.
std::vector<path> filesNamed(const std::string& soname, const LibraryKind& kind)
{
    std::vector<path> found;
    for (const path& folder : kind.folders) {
        addFiles(soname, folder, 0, found);
    }
    for (const path& tree : kind.trees) {
        addFiles(soname, tree, kDeepestFolder, found);
    }
    std::sort(found.begin(), found.end(),
              [](const path& a, const path& b) { return strverscmp(a.filename().c_str(), b.filename().c_str()) > 0; });
    std::stable_partition(found.begin(), found.end(),
                          [&soname](const path& file) { return file.filename() == soname; });
    return found;
}

path fileOf(void* handle)
{
    link_map* map = nullptr;
    return dlinfo(handle, RTLD_DI_LINKMAP, static_cast<void*>(&map)) == 0 && map != nullptr ? path(map->l_name)
                                                                                            : path();
}

} // namespace

VendorLibrary::VendorLibrary(const LibraryKind& kind, void* handle)
    : m_plugin(kind.plugin)
    , m_remedy(kind.remedy)
    , m_handle(handle)
    , m_file(fileOf(handle))
{
}

core::Result<VendorLibrary> VendorLibrary::open(const LibraryKind& kind, const path& named)
{
    const core::Message remedy(kind.remedy);
    const auto unreadable = [&](const path& file, const std::string& reason) {
        return Status(StatusCode::Unreadable, PALPATE_TEXT("%1: %2 could not be loaded (%3); %4"), kind.plugin, file,
                      reason, remedy);
    };
    if (!named.empty()) {
        if (!named.is_absolute()) {
            return Status(StatusCode::BadCommandLine,
                          PALPATE_TEXT("%1: the library \"%2\" in the settings is a relative path, expected one that "
                                       "begins with /"),
                          kind.plugin, named);
        }
        std::error_code error;
        if (!std::filesystem::exists(named, error)) {
            return Status(StatusCode::NotFound, PALPATE_TEXT("%1: %2, the library in the settings, was not found; %3"),
                          kind.plugin, named, remedy);
        }
        void* const handle = load(named.c_str());
        if (handle == nullptr) {
            return unreadable(named, loaderError());
        }
        return VendorLibrary(kind, handle);
    }
    Status broken; // the first file that was found but could not be loaded
    const auto tryFile = [&](const path& file, bool isSearched) -> void* {
        void* const handle = load(file.c_str());
        if (handle == nullptr && broken.isOk()) {
            const std::string reason = loaderError();
            // The loader's message begins with what is wrong: with the name itself only when no file has the name.
            if (!isSearched || !reason.starts_with(file.string() + ':')) {
                broken = unreadable(file, reason);
            }
        }
        return handle;
    };
    for (const std::string& soname : kind.sonames) {
        if (void* const handle = tryFile(soname, true)) {
            return VendorLibrary(kind, handle);
        }
    }
    for (const std::string& soname : kind.sonames) {
        for (const path& file : filesNamed(soname, kind)) {
            if (void* const handle = tryFile(file, false)) {
                return VendorLibrary(kind, handle);
            }
        }
    }
    if (!broken.isOk()) {
        return broken;
    }
    return Status(StatusCode::NotFound, PALPATE_TEXT("%1: %2 was not found; %3"), kind.plugin, kind.sonames.front(),
                  remedy);
}

void* VendorLibrary::resolve(const char* name) const
{
    return dlsym(m_handle, name);
}

Status VendorLibrary::status() const
{
    if (m_missing.empty()) {
        return {};
    }
    return {StatusCode::Mismatch,
            PALPATE_TEXT("%1: %2 lacks %3 of the needed functions, the first is %4: another version of the library; "
                         "%5"),
            m_plugin,
            m_file,
            m_missing.size(),
            m_missing.front(),
            core::Message(m_remedy)};
}

Status VendorLibrary::unsuitable(const std::string& found, const std::string& expected) const
{
    return {StatusCode::Mismatch,
            PALPATE_TEXT("%1: %2 is version %3, expected version %4; %5"),
            m_plugin,
            m_file,
            found,
            expected,
            core::Message(m_remedy)};
}

} // namespace palpate::vendor
