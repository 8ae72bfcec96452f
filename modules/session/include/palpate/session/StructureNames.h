// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

namespace palpate::session {

/// @return the name of a structure by its number in a tick's scene, empty when that has none of this number.
using StructureNames = std::function<std::string_view(std::uint32_t number)>;

} // namespace palpate::session
