// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/meshio/LoadScene.h>

#include <QJsonObject>

#include <string>
#include <vector>

namespace palpate::app {

/// The arrays of a structure's mesh, and how maps vary its tissue, a line each.
[[nodiscard]] std::vector<std::string> mapLines(const meshio::LoadedStructure& structure);

/// Adds `arrays` and `maps`, where there are any; resources/docs/info.md has their fields.
void addMaps(const meshio::LoadedStructure& structure, QJsonObject& object);

} // namespace palpate::app
