// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "JsonFields.h"

#include <palpate/core/ForceLaw.h>

#include <filesystem>

namespace palpate::meshio::internal {

/// Reads a structure's field `law`: absent, linear. A curve in a file of its own (`"file"`) is read here and kept as
/// points.
/// @param folder  that the file's path is relative to
void readLaw(JsonFields& structure, const std::filesystem::path& folder, core::ForceLaw& law);

/// Puts a law into a structure's object, beside its fields that this program does not know. A linear one is left out.
void writeLaw(const core::ForceLaw& law, QJsonObject& structure);

} // namespace palpate::meshio::internal
