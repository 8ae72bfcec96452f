// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/meshio/LoadScene.h"

#include <string>
#include <vector>

namespace palpate::meshio::internal {

/// Finds what varies over a structure: by the mappings of its description, else by the arrays whose names say it. Where
/// several say one quantity the last counts.
/// @param structure  with its surface; gets `maps`
/// @param warnings  gets a line for values that are missing
/// @param losses  gets a line for each map that can't be had
void resolveMaps(LoadedStructure& structure, std::vector<std::string>& warnings, std::vector<std::string>& losses);

} // namespace palpate::meshio::internal
