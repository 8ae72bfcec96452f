// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace palpate::meshio::internal {

/// Chooses a structure's colour: by the anatomy that its name says, else from a cycle that colour-blind people can
/// tell apart.
/// @param index  of the structure in its scene
[[nodiscard]] std::array<double, 3> anatomyColour(std::string_view name, std::size_t index);

} // namespace palpate::meshio::internal
