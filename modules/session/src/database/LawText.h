// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/ForceLaw.h>

#include <optional>
#include <string>
#include <string_view>

namespace palpate::session::internal {

/// Serializes a force law for the column `law` as JSON. @return empty for a linear law
[[nodiscard]] std::string lawText(const core::ForceLaw& law);
/// Parses a force law. @return empty for an invalid text or for missing or out-of-range numbers.
[[nodiscard]] std::optional<core::ForceLaw> parseLaw(std::string_view text);

} // namespace palpate::session::internal
