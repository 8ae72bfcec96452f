// SPDX-License-Identifier: BSD-3-Clause
#include "touch/MarkerShapes.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace palpate::view::internal {

namespace {

using Outline = std::vector<Eigen::Vector2d>;

Outline polygon(int corners, double radius_px, double first_rad)
{
    Outline out;
    for (int i = 0; i < corners; ++i) {
        const double angle = first_rad + 2.0 * std::numbers::pi * i / corners;
        out.emplace_back(radius_px * std::cos(angle), radius_px * std::sin(angle));
    }
    return out;
}

Outline cross()
{
    // Corners of a plus sign, rotated by 45°.
    constexpr double kArm_px = 6.6, kHalf_px = 2.0;
    const double c = std::numbers::sqrt2 / 2.0;
    Outline out;
    for (int quarter = 0; quarter < 4; ++quarter) {
        for (const auto& [x, y] : {std::pair(kArm_px, -kHalf_px), {kArm_px, kHalf_px}, {kHalf_px, kHalf_px}}) {
            Eigen::Vector2d p(x, y);
            for (int i = 0; i < quarter; ++i) {
                p = Eigen::Vector2d(-p.y(), p.x());
            }
            out.emplace_back(c * (p.x() - p.y()), c * (p.x() + p.y()));
        }
    }
    return out;
}

} // namespace

const std::vector<Eigen::Vector2d>& markerOutline(core::FindingType type)
{
    constexpr double kPi = std::numbers::pi;
    static const std::array<Outline, core::kFindingTypeNames.size()> kOutlines{
        polygon(20, 5.4, 0.0),       // lump
        polygon(4, 6.6, 0.0),        // hard area: standing on a corner
        polygon(4, 6.8, 0.25 * kPi), // soft area
        polygon(3, 6.8, 0.5 * kPi),  // landmark
        cross(),                     // keep away
        polygon(20, 5.6, 0.0)};      // other: a ring
    return kOutlines[static_cast<std::size_t>(type)];
}

} // namespace palpate::view::internal
