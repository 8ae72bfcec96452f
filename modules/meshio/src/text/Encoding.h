// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace palpate::meshio::internal {

/// Converts a name of unknown encoding to UTF-8. Names that are valid UTF-8 are unchanged; all others are read as
/// Windows-1252, the superset of Latin-1 that most programs without UTF-8 write.
[[nodiscard]] std::string utf8Of(std::string_view name);

/// Converts a text in UTF-16 to UTF-8. The byte order mark decides the byte order, or else the zero bytes of the first
/// characters; lone surrogates become U+FFFD.
/// @return nothing if the bytes are no text in UTF-16
[[nodiscard]] std::optional<std::string> fromUtf16(std::string_view bytes);

/// Overwrites the encoding in an XML declaration by blanks, which is wrong after a conversion to UTF-8.
void dropXmlEncoding(std::string& text);

} // namespace palpate::meshio::internal
