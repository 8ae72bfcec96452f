// SPDX-License-Identifier: BSD-3-Clause
#include "recording/StoredPath.h"

#include <system_error>

namespace palpate::session::internal {

namespace {

namespace fs = std::filesystem;

/// Resolves the folder of a file as far as it exists. The file itself may be a link, whose name is kept.
fs::path inResolvedFolder(const fs::path& file, std::error_code& error)
{
    const fs::path whole = fs::absolute(file, error);
    return error ? fs::path() : fs::weakly_canonical(whole.parent_path(), error) / whole.filename();
}

} // namespace

std::string storedPath(const std::string& file, const fs::path& recording)
{
    const fs::path given = fs::path(file).lexically_normal();
    if (!given.is_absolute()) {
        return file;
    }
    std::error_code fileError, recordingError; // without a working directory, or a folder that cannot be read
    const fs::path from = inResolvedFolder(recording, recordingError).parent_path();
    const fs::path relative = inResolvedFolder(given, fileError).lexically_relative(from);
    const bool isKnown = !fileError && !recordingError && !relative.empty() && relative != ".";
    return (isKnown ? relative : given.filename()).string();
}

std::string movedPath(const std::string& file, const fs::path& from, const fs::path& to)
{
    const fs::path there = from.parent_path() / file;
    std::error_code error;
    if (file.empty() || !fs::exists(there, error)) {
        return file;
    }
    const fs::path whole = fs::absolute(there, error);
    return error ? file : storedPath(whole.string(), to);
}

} // namespace palpate::session::internal
