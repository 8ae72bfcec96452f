// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

namespace palpate::session {

/// Returns the name of a structure from its index in the tick's scene, empty if there is no such index.
using StructureNames = std::function<std::string_view(std::uint32_t number)>;

} // namespace palpate::session
