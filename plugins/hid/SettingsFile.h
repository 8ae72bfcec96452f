// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <QJsonObject>

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::hid {

/// Settings of a device as the user wrote them.
struct SettingsFile
{
    std::filesystem::path path; ///< empty: there is no file
    QJsonObject object;         ///< empty without a file
};

/// Reads the JSON object in the file `name` of the first folder that contains one.
/// @param example  valid content, for the error message
/// @return Unreadable: the file cannot be read; BadFormat: the file contains no JSON object
[[nodiscard]] core::Result<SettingsFile> readSettingsFile(const std::vector<std::filesystem::path>& folders,
                                                          const std::string& name, const char* example);

} // namespace palpate::hid
