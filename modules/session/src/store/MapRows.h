// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/SurfaceMotion.h>
#include <palpate/haptics/TissueMap.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace palpate::session::internal {

/// What the table `maps` stores of a structure.
struct StoredMaps
{
    haptics::TissueMaps maps;
    std::shared_ptr<const geometry::SurfaceMotion> motion;
};

/// Serializes maps for the column `maps` of a structure: a JSON array with quantity, factor and SHA-256 of the values
/// of each map. A motion is the quantity "motion". Empty without either.
[[nodiscard]] std::string mapsText(const StoredMaps& maps);

/// Passes the SHA-256 (64 hex digits) and the values of each map, three floats per triangle in index order, and those
/// of the motion (SurfaceMotion::bytes).
void forEachMap(const StoredMaps& maps,
                const std::function<void(const std::string& sha256, std::string_view bytes)>& take);

/// Restores maps from the serialized text and verifies the hashes. Missing and damaged maps stay empty.
/// @param find  returns the bytes for a hash; empty if missing
[[nodiscard]] StoredMaps mapsOf(const std::string& text,
                                const std::function<std::optional<std::string>(const std::string&)>& find);

} // namespace palpate::session::internal
