// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <array>

namespace palpate::view {

/// Red, green and blue, each 0 to 1.
using Colour = std::array<double, 3>;

/// Colours of two compared hands, and of what both touched. They differ from the reds of tissue, and from each other
/// for people with red-green colour blindness. @par Source Okabe & Ito 2008, Color Universal Design: sky blue, yellow
inline constexpr Colour kFirstColour{0.34, 0.71, 0.91}, kSecondColour{0.94, 0.89, 0.26}, kBothColour{0.97, 0.97, 0.97};

/// Evaluates the cividis colour map, which looks nearly the same to people with and without red-green colour
/// blindness.
/// @param t  0 to 1, clamped; from dark blue to yellow with uniformly increasing lightness
/// @par Source Nuñez, Anderton, Renslow 2018, doi:10.1371/journal.pone.0199239
[[nodiscard]] PALPATE_EXPORT Colour cividis(double t) noexcept;

} // namespace palpate::view
