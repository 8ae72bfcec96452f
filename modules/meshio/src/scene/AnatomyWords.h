// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/meshio/AnatomyKind.h"

#include <array>
#include <string_view>

namespace palpate::meshio::internal {

/// Phrases that mean the same for touch and colour.
struct AnatomyWords
{
    AnatomyKind kind;
    std::array<int, 3> rgb;   ///< 0 … 255
    std::array<int, 3> safe;  ///< for colour-blind people, 0 … 255
    std::string_view phrases; ///< lower case, singular, separated by commas
};

/// @return the group of phrases that determines the kind of a name; nullptr if no phrase matches.
[[nodiscard]] const AnatomyWords* anatomyWords(std::string_view name);

} // namespace palpate::meshio::internal
