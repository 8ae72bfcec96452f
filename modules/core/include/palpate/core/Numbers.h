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

/// Writes a number for people, independent of the locale: at most `digits` significant digits (1 to 17) and no
/// exponent, "79300" and "0.00002". Beyond 10¹⁵ and below 10⁻⁶ a power of ten follows: "2.3·10⁻¹³".
[[nodiscard]] PALPATE_EXPORT std::string shortNumber(double value, int digits = 6);

} // namespace palpate::core
