// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/meshio/SceneMotion.h"
#include "text/JsonFields.h"

#include <QJsonObject>

#include <filesystem>
#include <optional>

namespace palpate::meshio::internal {

/// Reads the fields `motion` and `pulse` of a structure. @param folder  of the scene file
void readMotion(JsonFields& structure, const std::filesystem::path& folder, std::optional<SceneMotion>& motion,
                std::optional<ScenePulse>& pulse);

/// Writes them; unknown fields that are already in `structure` are kept.
void writeMotion(const std::optional<SceneMotion>& motion, const std::optional<ScenePulse>& pulse,
                 const std::filesystem::path& folder, QJsonObject& structure);

} // namespace palpate::meshio::internal
