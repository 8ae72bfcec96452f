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
using core::inQuotes;

/// Describes an error in a file by a message whose parts are translated separately.
/// @param place     where in the file: `onLine`, `onByte` or a message of the format; may be empty
/// @param expected  may be empty
[[nodiscard]] core::Status fault(core::StatusCode code, std::string_view file, const core::Message& place,
                                 const core::Message& found, const core::Message& expected = {});

/// @return "line 48634"
[[nodiscard]] core::Message onLine(std::uint64_t line);
/// @return "byte 84"
[[nodiscard]] core::Message onByte(std::uint64_t byte);

} // namespace palpate::meshio::internal
