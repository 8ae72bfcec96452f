// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace palpate::core {

/// Reads a decimal number that fills `text` but for blanks around it; the same under every locale.
/// @return nothing when `text` is not such a number. "nan" and "inf" are numbers here: the caller checks finiteness.
[[nodiscard]] std::optional<double> parseNumber(std::string_view text) noexcept;

/// Writes with 17 significant digits, which give the same double back; the same under every locale.
void appendNumber(std::string& out, double value);

/// @return a number for a message, with so many significant digits; the same under every locale.
[[nodiscard]] std::string shortNumber(double value, int digits = 6);

} // namespace palpate::core
