// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Message.h>
#include <palpate/core/Status.h>
#include <palpate/core/Text.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace palpate::meshio::internal {

using core::Count;
using core::grouped;
using core::inQuotes;

/// Describes an error in a file in one line: "liver.stl: byte 80: 3 triangles declared, 2 held; expected …".
/// @param place  where in the file, "line 12" or "byte 84"; may be empty
[[nodiscard]] core::Status fault(core::StatusCode code, std::string_view file, std::string_view place,
                                 std::string_view found, std::string_view expected);

/// Describes an error in a file by a message whose parts are translated separately.
/// @param place     where in the file: `onLine`, `onByte` or a message of the format; may be empty
/// @param expected  may be empty
[[nodiscard]] core::Status fault(core::StatusCode code, std::string_view file, const core::Message& place,
                                 const core::Message& found, const core::Message& expected = {});

/// @return "line 48,634"
[[nodiscard]] core::Message onLine(std::uint64_t line);
/// @return "byte 84"
[[nodiscard]] core::Message onByte(std::uint64_t byte);

/// @return "line 48,634"
[[nodiscard]] std::string atLine(std::uint64_t line);
/// @return "byte 84"
[[nodiscard]] std::string atByte(std::uint64_t byte);

/// @return "1 triangle", "2 triangles"
[[nodiscard]] std::string counted(std::uint64_t value, std::string_view noun);

} // namespace palpate::meshio::internal
