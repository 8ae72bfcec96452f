// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/ColourMap.h"

#include <palpate/core/Export.h>

#include <string>

class vtkTextProperty;

namespace palpate::view {

/// Style of all texts in the view; the size follows the window's font.
struct TextStyle
{
    double size_px = 12.0;          ///< font size of the window, logical pixels; the view's texts are slightly larger
    std::string decimalPoint = "."; ///< UTF-8
    std::string fontFile;           ///< bold font (TrueType or OpenType) of all texts; empty: VTK's own
    double groundOpacity = 0.85;    ///< opacity of the background behind texts on tissue

    friend bool operator==(const TextStyle&, const TextStyle&) = default;
};

/// Background colour behind texts on tissue, and text colour for texts that belong to no structure.
inline constexpr Colour kTextGround{0.08, 0.09, 0.11};
inline constexpr Colour kTextColour{1.0, 1.0, 1.0};

/// Lightens a structure's colour for use as text colour, readable on the dark background even where tissue shines
/// through.
[[nodiscard]] PALPATE_EXPORT Colour textColourOf(const Colour& colour);

/// Purpose of a text.
enum class TextUse
{
    Usual,
    Large ///< the most important number
};

/// Font size, at least 8. @param pixelRatio  device pixels per logical pixel  [device px]
[[nodiscard]] PALPATE_EXPORT int letterSize_px(const TextStyle& style, TextUse use, double pixelRatio);

/// Sets font and font size.
PALPATE_EXPORT void setFont(vtkTextProperty& text, const TextStyle& style, TextUse use, double pixelRatio);

/// Formats with a fixed number of decimals ("4.60"), independent of the C locale.
[[nodiscard]] PALPATE_EXPORT std::string fixedText(double value, int decimals, const std::string& decimalPoint);
/// Formats with at most `digits` significant digits and without an exponent ("0.0425"), as `core::shortNumber`.
[[nodiscard]] PALPATE_EXPORT std::string shortText(double value, int digits, const std::string& decimalPoint);

} // namespace palpate::view
