// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/ForceLaw.h>

#include <optional>
#include <string>
#include <string_view>

namespace palpate::session::internal {

/// A law as the column `law` holds it: JSON, numbers by their keys. @return empty for a linear one
[[nodiscard]] std::string lawText(const core::ForceLaw& law);
/// @return nothing when the text is no law, or one of its numbers is missing or out of its range.
[[nodiscard]] std::optional<core::ForceLaw> parseLaw(std::string_view text);

} // namespace palpate::session::internal
