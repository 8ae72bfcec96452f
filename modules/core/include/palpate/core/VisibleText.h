// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Export.h"

#include <string>
#include <string_view>

namespace palpate::core {

/// Escapes text for a terminal or a one-line message: control characters (C0, DEL, C1), line and paragraph separators,
/// bidirectional control characters and invalid UTF-8 become escapes such as `\x1b` and `\u202e`. Other characters are
/// kept. Names in files could otherwise forge or hide output.
[[nodiscard]] PALPATE_EXPORT std::string visible(std::string_view text);

/// Escapes JSON text without changing the parsed value: line ends are kept, and only characters that JSON can escape
/// are replaced.
[[nodiscard]] PALPATE_EXPORT std::string visibleJson(std::string_view json);

} // namespace palpate::core
