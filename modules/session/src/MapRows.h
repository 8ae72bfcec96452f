// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/haptics/TissueMap.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace palpate::session::internal {

/// What the column `maps` of a structure says: a JSON array with quantity, factor and the SHA-256 of each map's
/// numbers. Empty without a map.
[[nodiscard]] std::string mapsText(const haptics::TissueMaps& maps);

/// Gives each map's SHA-256 (64 hex digits) and its numbers, three floats for each triangle in the index's order.
void forEachMap(const haptics::TissueMaps& maps,
                const std::function<void(const std::string& sha256, std::string_view bytes)>& take);

/// The inverse: finds the numbers by their hash and checks them.
/// @param find  gives the bytes of a hash; nothing where they are not there
/// @param wrong  says what could not be had, one line; empty when nothing
[[nodiscard]] haptics::TissueMaps mapsOf(const std::string& text,
                                         const std::function<std::optional<std::string>(const std::string&)>& find,
                                         std::string& wrong);

} // namespace palpate::session::internal
