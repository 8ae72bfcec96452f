// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/meshio/LoadScene.h>

#include <QJsonObject>

#include <string>
#include <vector>

namespace palpate::app {

/// Describes the arrays of a structure's mesh and the maps that vary its tissue, one line each.
[[nodiscard]] std::vector<std::string> mapLines(const meshio::LoadedStructure& structure);

/// Adds the fields `arrays` and `maps`, if not empty; see resources/docs/info.md.
void addMaps(const meshio::LoadedStructure& structure, QJsonObject& object);

} // namespace palpate::app
