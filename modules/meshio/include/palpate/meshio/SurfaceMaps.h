// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/meshio/LoadScene.h"

#include <palpate/core/Message.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace palpate::meshio {

/// @return the mappings implied by the array names of a mesh (core::kKnownMaps).
[[nodiscard]] std::vector<core::TissueMapping> knownMappings(const geometry::TriangleMesh& mesh);

/// Resolves the maps that vary a structure's tissue: the mappings of the description, or else the arrays with known
/// names. If several mappings set the same quantity, the last one applies.
/// @param structure  with a surface; replaces `maps`
/// @param warnings  receives a line for missing values
/// @param losses  receives a line for each map that cannot be loaded
/// @param keepGoing  polled on the calling thread while a volume is sampled; false cancels and drops the map
/// @par Thread Any.
/// @par Cost O(vertices) for an array; reading and sampling a volume can take seconds.
void resolveMaps(LoadedStructure& structure, std::vector<core::Message>& warnings, std::vector<core::Message>& losses,
                 const std::function<bool()>& keepGoing = {});

/// @return the number of missing values in a map, where the structure's own value applies.
[[nodiscard]] std::size_t missingValues(const SurfaceMap& map) noexcept;

} // namespace palpate::meshio
