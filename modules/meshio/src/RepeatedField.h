// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace palpate::meshio::internal {

/// Finds a field that an object of a JSON document has twice. Parsers keep one of the two without a word, and which one
/// differs between them (RFC 8259, section 4), so that two programs would read two different scenes.
/// @param json  a document that a parser has taken
/// @return the path of the first such field, "structures[2].opacity"; nothing when each field is there once
[[nodiscard]] std::optional<std::string> repeatedField(std::string_view json);

} // namespace palpate::meshio::internal
