// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/ChartAxis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace palpate::study {

namespace {

std::string inFormat(const char* format, double value)
{
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
}

std::string superscript(int exponent)
{
    static constexpr std::array<const char*, 10> kDigits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string result = exponent < 0 ? "⁻" : "";
    for (const char c : std::to_string(std::abs(exponent))) {
        result += kDigits[static_cast<std::size_t>(c - '0')];
    }
    return result;
}

} // namespace

std::string escaped(std::string_view in)
{
    std::string out;
    for (const char c : in) {
        switch (c) {
        case '&':
            out += "&amp;";
            break;
        case '<':
            out += "&lt;";
            break;
        case '>':
            out += "&gt;";
            break;
        case '"':
            out += "&quot;";
            break;
        default:
            out += c;
        }
    }
    return out;
}

std::string shortNumber(double value)
{
    if (value == 0.0 || !std::isfinite(value)) {
        return value == 0.0 ? "0" : std::isnan(value) ? "not a number" : "infinite";
    }
    const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9));
    if (exponent >= -3 && exponent < 6) {
        return exponent >= 2 ? inFormat("%.0f", value) : inFormat("%.3g", value);
    }
    const double mantissa = value / std::pow(10.0, exponent);
    const std::string power = "10" + superscript(exponent);
    return std::abs(mantissa - 1.0) < 0.05 ? power : inFormat("%.1f·", mantissa) + power;
}

ChartAxis ChartAxis::decades(const std::vector<double>& values, std::string title)
{
    double low = std::numeric_limits<double>::infinity(), high = 0.0;
    for (const double v : values) {
        if (v > 0.0 && std::isfinite(v)) {
            low = std::min(low, v);
            high = std::max(high, v);
        }
    }
    if (high == 0.0) {
        low = high = 1.0;
    }
    const double first = std::floor(std::log10(low) - 0.05), last = std::ceil(std::log10(high) + 0.05);
    return {std::pow(10.0, first), std::pow(10.0, std::max(last, first + 1.0)), true, std::move(title)};
}

ChartAxis ChartAxis::linear(const std::vector<double>& values, std::string title)
{
    double high = 0.0;
    for (const double v : values) {
        high = std::max(high, v);
    }
    high = high > 0.0 ? high : 1.0;
    const double step = std::pow(10.0, std::floor(std::log10(high)));
    return {0.0, step * std::ceil(high / step * 2.0 - 1e-9) / 2.0, false, std::move(title)};
}

double ChartAxis::share(double value) const
{
    const double s =
        isLog ? (std::log10(std::max(value, 1e-300)) - std::log10(low)) / (std::log10(high) - std::log10(low))
              : (value - low) / (high - low);
    return std::clamp(s, 0.0, 1.0);
}

std::vector<double> ChartAxis::ticks() const
{
    std::vector<double> result;
    if (isLog) {
        const int first = static_cast<int>(std::lround(std::log10(low)));
        const int last = static_cast<int>(std::lround(std::log10(high)));
        const int step = std::max(1, (last - first + 8) / 9);
        for (int e = first; e <= last; e += step) {
            result.push_back(std::pow(10.0, e));
        }
        return result;
    }
    const double range = high - low, decade = std::pow(10.0, std::floor(std::log10(range)));
    const double step = range / decade > 5 ? decade : range / decade > 2 ? decade / 2 : decade / 5;
    for (double v = std::ceil(low / step - 1e-9) * step; v <= high + 1e-9 * range; v += step) {
        result.push_back(std::abs(v) < 1e-9 * step ? 0.0 : v);
    }
    return result;
}

} // namespace palpate::study
