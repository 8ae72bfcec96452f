// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/core/Numbers.h"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace palpate::core {

std::optional<double> parseNumber(std::string_view text) noexcept
{
    constexpr std::string_view kBlanks = " \t\r";
    const auto first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) {
        return std::nullopt;
    }
    text = text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
    if (text.size() > 1 && text.front() == '+' && text[1] != '-') {
        text.remove_prefix(1); // from_chars does not accept a plus sign
    }
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) {
        return std::nullopt;
    }
    return value;
}

void appendNumber(std::string& out, double value)
{
    char digits[32];
    const auto result = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 17);
    out.append(digits, result.ptr);
}

std::string shortNumber(double value, int digits)
{
    char text[40]; // 17 digits with sign, point and exponent need 24
    const auto result =
        std::to_chars(text, text + sizeof text, value, std::chars_format::general, std::clamp(digits, 1, 17));
    return {text, result.ptr};
}

} // namespace palpate::core
