// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace palpate::session::internal {

/// Returns the form in which a recording stores the path of a file, so that the recording contains no absolute path:
/// relative to the folder of the recording, with `..` if necessary. The folder is resolved first, because `..` leads to
/// the parent of a link's target.
/// @param file  a relative path is returned unchanged
/// @return the file name if the path cannot be made relative
[[nodiscard]] std::string storedPath(const std::string& file, const std::filesystem::path& recording);

/// Returns a stored path for a copy in another folder. @param file  unchanged unless it leads to a file from the folder
/// of `from`
[[nodiscard]] std::string movedPath(const std::string& file, const std::filesystem::path& from,
                                    const std::filesystem::path& to);

} // namespace palpate::session::internal
