// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace palpate::meshio::internal {

/// Says what is wrong with a file in one line: "liver.stl: byte 80: 3 triangles declared, 2 held; expected …".
/// @param place  where in the file, "line 12" or "byte 84"; may be empty
[[nodiscard]] core::Status fault(core::StatusCode code, std::string_view file, std::string_view place,
                                 std::string_view found, std::string_view expected);

/// @return "line 48,634"
[[nodiscard]] std::string atLine(std::uint64_t line);
/// @return "byte 84"
[[nodiscard]] std::string atByte(std::uint64_t byte);

/// @return 1234567 as "1,234,567"
[[nodiscard]] std::string grouped(std::uint64_t value);

/// @return "1 triangle", "2 triangles"
[[nodiscard]] std::string counted(std::uint64_t value, std::string_view noun);

/// @return `text` in quotes, cut to what fits in a line, with everything but printable ASCII and UTF-8 replaced
[[nodiscard]] std::string inQuotes(std::string_view text);

} // namespace palpate::meshio::internal
