// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/core/Numbers.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdlib>
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

namespace {

/// Powers of ten that are written out; others would be rows of zeros.
constexpr int kLeastExponent = -6, kMostExponent = 15;

std::string superscript(int exponent)
{
    constexpr std::string_view kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(exponent))) {
        text += kDigits[digit - '0'];
    }
    return text;
}

} // namespace

std::string shortNumber(double value, int digits)
{
    char text[40]; // 17 digits with sign, point and exponent need 24
    const char* const end =
        std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, std::clamp(digits, 1, 17) - 1)
            .ptr;
    const std::string_view written(text, static_cast<std::size_t>(end - text));
    const std::size_t e = written.find('e');
    if (e == std::string_view::npos) {
        return std::string(written); // not a number, or infinite
    }
    int exponent = 0;
    const std::size_t from = written[e + 1] == '+' ? e + 2 : e + 1; // from_chars does not accept a plus sign
    (void)std::from_chars(written.data() + from, end, exponent);
    const bool isNegative = written.front() == '-';
    std::string figures;
    for (const char one : written.substr(0, e)) {
        if (one >= '0' && one <= '9') {
            figures += one;
        }
    }
    figures.erase(figures.find_last_not_of('0') + 1);
    if (figures.empty()) {
        return "0";
    }
    const std::string sign = isNegative ? "-" : "";
    if (exponent < kLeastExponent || exponent > kMostExponent) {
        const std::string power = "10" + superscript(exponent);
        if (figures == "1") {
            return sign + power;
        }
        std::string out = sign + figures.substr(0, 1);
        if (figures.size() > 1) {
            out += '.';
            out.append(figures, 1);
        }
        return out + "·" + power;
    }
    if (exponent < 0) {
        return sign + "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + figures;
    }
    const auto whole = static_cast<std::size_t>(exponent) + 1;
    if (figures.size() <= whole) {
        return sign + figures + std::string(whole - figures.size(), '0');
    }
    return sign + figures.substr(0, whole) + "." + figures.substr(whole);
}

} // namespace palpate::core
