// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <array>

namespace palpate::view {

/// Red, green and blue, each 0 to 1.
using Colour = std::array<double, 3>;

/// Evaluates the cividis colour map, which looks nearly the same to people with and without red-green colour
/// blindness.
/// @param t  0 to 1, clamped; from dark blue to yellow with uniformly increasing lightness
/// @par Source Nuñez, Anderton, Renslow 2018, doi:10.1371/journal.pone.0199239
[[nodiscard]] PALPATE_EXPORT Colour cividis(double t) noexcept;

} // namespace palpate::view
