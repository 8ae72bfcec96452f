// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace palpate::view {

/// Red, green, blue, each 0 … 1.
using Colour = std::array<double, 3>;

/// The cividis map, which reads the same with and without red-green colour blindness.
/// @param t  0 … 1, clamped; dark blue to yellow, lightness rising evenly
/// @par Source Nuñez, Anderton, Renslow 2018, doi:10.1371/journal.pone.0199239
[[nodiscard]] Colour cividis(double t) noexcept;

} // namespace palpate::view
