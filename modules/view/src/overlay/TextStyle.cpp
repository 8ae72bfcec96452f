// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/TextStyle.h"

#include <palpate/core/Numbers.h>

#include <vtkTextProperty.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace palpate::view {

namespace {

// The 3D view is read from farther away than a panel.
constexpr double kUsual = 1.1, kLarge = 1.25; // relative to the window's font size
constexpr int kLeast_px = 8;

std::string numberText(double value, std::chars_format format, int precision, const std::string& decimalPoint)
{
    char digits[400]; // the largest double has 309 digits before the decimal point
    const auto end = std::to_chars(digits, digits + sizeof digits, value, format, precision).ptr;
    std::string text(digits, end);
    if (const std::size_t point = text.find('.'); point != std::string::npos) {
        text.replace(point, 1, decimalPoint);
    }
    return text;
}

} // namespace

Colour textColourOf(const Colour& colour)
{
    constexpr double kLeast = 0.65;
    Colour ink{};
    for (std::size_t i = 0; i < ink.size(); ++i) {
        ink[i] = kLeast + (1.0 - kLeast) * colour[i];
    }
    return ink;
}

int letterSize_px(const TextStyle& style, TextUse use, double pixelRatio)
{
    const double share = use == TextUse::Large ? kLarge : kUsual;
    return std::max(kLeast_px, static_cast<int>(std::lround(share * style.size_px * pixelRatio)));
}

void setFont(vtkTextProperty& text, const TextStyle& style, TextUse use, double pixelRatio)
{
    if (style.fontFile.empty()) {
        text.SetFontFamilyToArial();
    } else {
        text.SetFontFamily(VTK_FONT_FILE);
        text.SetFontFile(style.fontFile.c_str());
    }
    text.SetBold(style.fontFile.empty());
    text.SetFontSize(letterSize_px(style, use, pixelRatio));
}

std::string fixedText(double value, int decimals, const std::string& decimalPoint)
{
    return numberText(value, std::chars_format::fixed, decimals, decimalPoint);
}

std::string shortText(double value, int digits, const std::string& decimalPoint)
{
    std::string text = core::shortNumber(value, digits);
    if (const std::size_t point = text.find('.'); point != std::string::npos) {
        text.replace(point, 1, decimalPoint);
    }
    return text;
}

} // namespace palpate::view
