// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace palpate::meshio::internal {

/// Finds a duplicate field name in an object of a JSON document. Parsers silently keep one of the two values, and the
/// choice differs between parsers (RFC 8259, section 4), so that two programs could read different scenes.
/// @param json  a document that was parsed without an error
/// @return the path of the first duplicate, "structures[2].opacity"; nothing if there is no duplicate
[[nodiscard]] std::optional<std::string> repeatedField(std::string_view json);

} // namespace palpate::meshio::internal
