// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "text/JsonFields.h"

#include <palpate/core/ForceLaw.h>

#include <filesystem>

namespace palpate::meshio::internal {

/// Reads the field `law` of a structure; absent: linear. A curve in a separate file (`"file"`) is read and stored as
/// points.
/// @param folder  base of the relative path
void readLaw(JsonFields& structure, const std::filesystem::path& folder, core::ForceLaw& law);

/// Writes a law to a structure's object and keeps fields unknown to this version. A linear law is omitted.
void writeLaw(const core::ForceLaw& law, QJsonObject& structure);

} // namespace palpate::meshio::internal
