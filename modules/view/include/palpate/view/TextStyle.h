// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/ColourMap.h"

#include <string>

class vtkTextProperty;

namespace palpate::view {

/// How the view's texts look: all of one font, as large as the window's.
struct TextStyle
{
    double size_px = 12.0;          ///< of the window's letters, logical pixels; the view's are a little larger
    std::string decimalPoint = "."; ///< UTF-8
    double groundOpacity = 0.85;    ///< of the ground behind a text that stands on tissue

    friend bool operator==(const TextStyle&, const TextStyle&) = default;
};

/// The ground behind a text that stands on tissue, and the ink of a text that belongs to no structure.
inline constexpr Colour kTextGround{0.08, 0.09, 0.11};
inline constexpr Colour kTextInk{1.0, 1.0, 1.0};

/// A structure's colour as ink: so light that it reads on the ground, whatever tissue shines through that.
[[nodiscard]] Colour inkOf(const Colour& colour);

/// What a text is for.
enum class TextUse
{
    Usual,
    Large ///< the number that is looked for first
};

/// Size of letters, at least 8. @param pixelRatio  device pixels of one logical pixel  [device px]
[[nodiscard]] int letterSize_px(const TextStyle& style, TextUse use, double pixelRatio);

/// Sets font and size.
void setFont(vtkTextProperty& text, const TextStyle& style, TextUse use, double pixelRatio);

/// "4.60" with a number of decimals, independent of the C locale.
[[nodiscard]] std::string fixedText(double value, int decimals, const std::string& decimalPoint);
/// "0.0425" with at most so many significant digits, independent of the C locale.
[[nodiscard]] std::string shortText(double value, int digits, const std::string& decimalPoint);

} // namespace palpate::view
