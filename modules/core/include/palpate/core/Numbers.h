// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Export.h"

#include <optional>
#include <string>
#include <string_view>

namespace palpate::core {

/// Parses a decimal number, independent of the locale. The whole text must be the number, apart from surrounding
/// blanks.
/// @return std::nullopt if `text` is not a number. Accepts "nan" and "inf": the caller checks finiteness.
[[nodiscard]] PALPATE_EXPORT std::optional<double> parseNumber(std::string_view text) noexcept;

/// Appends a number with 17 significant digits (lossless round trip), independent of the locale.
PALPATE_EXPORT void appendNumber(std::string& out, double value);

/// @return the number with `digits` significant digits for a message, independent of the locale.
[[nodiscard]] PALPATE_EXPORT std::string shortNumber(double value, int digits = 6);

} // namespace palpate::core
