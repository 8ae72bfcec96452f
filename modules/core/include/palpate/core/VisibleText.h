// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace palpate::core {

/// @return `text` as it may go to a terminal or into one line of a message: control characters (C0, DEL, C1), line and
/// paragraph separators, characters that change the direction of writing, and bytes that are not UTF-8 become escapes
/// such as `\x1b` and `\u202e`; all else is kept. Names in files can hold any of them, to forge or hide output.
[[nodiscard]] std::string visible(std::string_view text);

/// The same for JSON text, which stays the same JSON: line ends are kept, and only what JSON can escape is.
[[nodiscard]] std::string visibleJson(std::string_view json);

} // namespace palpate::core
