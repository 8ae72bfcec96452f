// SPDX-License-Identifier: BSD-3-Clause
#include "scene/AnatomyColours.h"

#include "palpate/meshio/AnatomyPalette.h"

#include "scene/AnatomyWords.h"

namespace palpate::meshio {

using internal::AnatomyWords;

namespace {

/// Okabe and Ito's palette without black.
constexpr std::array kCycle = std::to_array<std::array<int, 3>>(
    {{230, 159, 0}, {86, 180, 233}, {0, 158, 115}, {240, 228, 66}, {0, 114, 178}, {213, 94, 0}, {204, 121, 167}});

std::array<double, 3> fraction(const std::array<int, 3>& rgb)
{
    return {rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0};
}

} // namespace

std::array<double, 3> internal::anatomyColour(std::string_view name, std::size_t index)
{
    const AnatomyWords* known = internal::anatomyWords(name);
    return fraction(known != nullptr ? known->rgb : kCycle[index % kCycle.size()]);
}

std::array<double, 3> safeColour(std::string_view name, std::size_t number)
{
    const AnatomyWords* known = internal::anatomyWords(name);
    return fraction(known != nullptr ? known->safe : kCycle[number % kCycle.size()]);
}

} // namespace palpate::meshio
