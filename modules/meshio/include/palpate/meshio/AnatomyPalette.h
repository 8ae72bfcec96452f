// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <array>
#include <cstddef>
#include <string_view>

namespace palpate::meshio {

/// Returns the colour of a structure by the anatomical term in its name, or else by number, from a palette in which
/// colour-blind people can distinguish lumps, arteries, portal vein, other veins, ducts and organs.
/// @return red, green and blue, 0 to 1
[[nodiscard]] PALPATE_EXPORT std::array<double, 3> safeColour(std::string_view name, std::size_t number);

} // namespace palpate::meshio
