// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/ColourMap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace palpate::view {

Colour cividis(double t) noexcept
{
    // Ten equidistant colours of the published map, 0 to 255.
    static constexpr std::array<std::array<unsigned char, 3>, 10> kAnchors{{{0, 32, 77},
                                                                            {0, 51, 111},
                                                                            {57, 72, 107},
                                                                            {87, 92, 109},
                                                                            {112, 113, 115},
                                                                            {138, 135, 121},
                                                                            {166, 157, 117},
                                                                            {196, 181, 108},
                                                                            {228, 207, 91},
                                                                            {255, 234, 70}}};
    const double place = std::clamp(std::isfinite(t) ? t : 0.0, 0.0, 1.0) * (kAnchors.size() - 1);
    const std::size_t low = std::min(static_cast<std::size_t>(place), kAnchors.size() - 2);
    const double share = place - static_cast<double>(low);
    Colour colour{};
    for (std::size_t c = 0; c < 3; ++c) {
        colour[c] = ((1.0 - share) * kAnchors[low][c] + share * kAnchors[low + 1][c]) / 255.0;
    }
    return colour;
}

} // namespace palpate::view
