// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/meshio/LoadScene.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace palpate::meshio {

/// @return what the arrays of a mesh say by their names alone (core::kKnownMaps).
[[nodiscard]] std::vector<core::TissueMapping> knownMappings(const geometry::TriangleMesh& mesh);

/// Finds what varies over a structure: by the mappings of its description, else by the arrays whose names say it. Where
/// several say one quantity the last counts.
/// @param structure  with its surface; its `maps` are replaced
/// @param warnings  gets a line for values that are missing
/// @param losses  gets a line for each map that can't be had
/// @param keepGoing  asked now and then while a volume is sampled, on the calling thread; false cancels: it is lost
/// @par Thread Any.
/// @par Cost O(vertices) for an array; a volume is read and sampled, which can take seconds.
void resolveMaps(LoadedStructure& structure, std::vector<std::string>& warnings, std::vector<std::string>& losses,
                 const std::function<bool()>& keepGoing = {});

/// @return how many values of a map are not known: the structure's own is felt there.
[[nodiscard]] std::size_t missingValues(const SurfaceMap& map) noexcept;

} // namespace palpate::meshio
