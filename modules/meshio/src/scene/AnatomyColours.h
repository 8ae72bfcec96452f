// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace palpate::meshio::internal {

/// Chooses the colour of a structure: by the anatomical term in the name, otherwise from a cycle that colour-blind
/// people can distinguish.
/// @param index  of the structure in its scene
[[nodiscard]] std::array<double, 3> anatomyColour(std::string_view name, std::size_t index);

} // namespace palpate::meshio::internal
