// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/EffortDepth.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate::study {

namespace {

using haptics::kFeltPress_mm;
using haptics::TissueMap;

/// Interpolates a map linearly between the corners of a triangle; 1 without a map.
double mapAt(const TissueMap& map, const PressedSurface& at) noexcept
{
    if (map.isEmpty()) {
        return 1.0;
    }
    const geometry::SurfaceIndex& surface = *at.structure->surface;
    const geometry::Triangle corners = surface.triangle(at.triangle);
    const core::Vec3& a = surface.vertex(corners[0]);
    const core::Vec3 u = surface.vertex(corners[1]) - a, v = surface.vertex(corners[2]) - a;
    const core::Vec3 n = u.cross(v);
    const double area2 = n.squaredNorm(); // > 0 in an index
    const double second = std::clamp((at.p_W - a).cross(v).dot(n) / area2, 0.0, 1.0);
    const double third = std::clamp(u.cross(at.p_W - a).dot(n) / area2, 0.0, 1.0 - second);
    const std::array<float, 3>& value = (*map.corners)[at.triangle];
    return map.factor *
           ((1.0 - second - third) * double{value[0]} + second * double{value[1]} + third * double{value[2]});
}

/// Returns the force ratio due to buried lumps at a depth, linear between the press depths of the maps.
double lumpRatioAt(const PressedSurface& at, double depth_mm) noexcept
{
    const auto& felt = at.structure->maps.felt;
    if (!at.structure->maps.hasFelt()) {
        return 1.0;
    }
    const auto above = std::upper_bound(kFeltPress_mm.begin(), kFeltPress_mm.end(), depth_mm);
    if (above == kFeltPress_mm.end()) {
        return mapAt(felt.back(), at);
    }
    const auto j = static_cast<std::size_t>(above - kFeltPress_mm.begin()); // >= 1, because depth_mm > 0
    const double share = (depth_mm - kFeltPress_mm[j - 1]) / (kFeltPress_mm[j] - kFeltPress_mm[j - 1]);
    return (1.0 - share) * mapAt(felt[j - 1], at) + share * mapAt(felt[j], at);
}

} // namespace

double PressedSurface::force_N(double depth_mm) const noexcept
{
    if (!(depth_mm > 0.0)) {
        return 0.0;
    }
    return mapAt(structure->maps.stiffness, *this) * lumpRatioAt(*this, depth_mm) * structure->lawAt(depth_mm).force_N;
}

double pressForce_N(std::span<const PressedSurface> surfaces, double way_mm) noexcept
{
    double force_N = 0.0;
    for (const PressedSurface& one : surfaces) {
        force_N += one.force_N(one.slant * (way_mm - one.entry_mm));
    }
    return force_N;
}

double pressTravel_mm(std::span<const PressedSurface> surfaces, double force_N, double deepest_mm) noexcept
{
    constexpr int kSteps = 256, kHalvings = 60;
    double from_mm = deepest_mm;
    for (const PressedSurface& one : surfaces) {
        from_mm = std::min(from_mm, one.entry_mm);
    }
    if (!(force_N > 0.0)) {
        return from_mm;
    }
    double low_mm = from_mm, high_mm = from_mm;
    bool isMet = false;
    for (int i = 1; i <= kSteps && !isMet; ++i) {
        low_mm = high_mm;
        high_mm = from_mm + (deepest_mm - from_mm) * i / kSteps;
        isMet = pressForce_N(surfaces, high_mm) >= force_N;
    }
    if (!isMet) {
        return deepest_mm;
    }
    for (int i = 0; i < kHalvings; ++i) {
        const double middle_mm = 0.5 * (low_mm + high_mm);
        (pressForce_N(surfaces, middle_mm) >= force_N ? high_mm : low_mm) = middle_mm;
    }
    return high_mm;
}

} // namespace palpate::study
