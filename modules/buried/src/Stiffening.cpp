// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/buried/Stiffening.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace palpate::buried {

namespace {

/// Shares leave the range 0 to 1 only through rounding or self-intersecting meshes.
double bounded(double share) noexcept
{
    return std::clamp(share, 0.0, 1.0);
}

} // namespace

Stiffening stiffening(double share, double ratio) noexcept
{
    const LumpShare one{share, ratio};
    return stiffening(std::span(&one, 1));
}

Stiffening stiffening(std::span<const LumpShare> lumps) noexcept
{
    double sum = 0.0;
    for (const LumpShare& lump : lumps) {
        sum += bounded(lump.share);
    }
    const double excess = std::max(1.0, sum); // overlapping lumps: limit the total to the whole press
    double softened = 0.0, estimated = 0.0, stiffened = 0.0;
    for (const LumpShare& lump : lumps) {
        const double share = bounded(lump.share) / excess, by = lump.ratio - 1.0;
        if (share == 0.0) {
            continue; // avoids 0 * infinity for a rigid lump without a share
        }
        softened += share * (1.0 - 1.0 / lump.ratio);
        stiffened += share * by;
        const double whole = bounded(sum), rest = kBeta * (1.0 + whole) * (1.0 - whole);
        if (std::isinf(lump.ratio)) {
            estimated += rest > 0.0 ? share / rest : by;
        } else {
            estimated += share * by / (1.0 + rest * by);
        }
    }
    const double low = softened < 1.0 ? 1.0 / (1.0 - softened) : std::numeric_limits<double>::infinity();
    return {low, 1.0 + estimated, 1.0 + stiffened};
}

double pressureScale(double radius_mm) noexcept
{
    return radius_mm / std::numbers::pi;
}

double pressDensity(double r_mm, double z_mm, double radius_mm) noexcept
{
    if (z_mm <= 0.0) {
        return 0.0;
    }
    const double c = pressureScale(radius_mm), h = z_mm + c, distance2 = r_mm * r_mm + h * h;
    return 6.0 * c / std::numbers::pi * z_mm * z_mm / (distance2 * distance2 * distance2);
}

double shareBelow(double depth_mm, double radius_mm) noexcept
{
    const double part = depth_mm / (depth_mm + pressureScale(radius_mm));
    return 1.0 - part * part * part;
}

double shareOfSphere(double sphereRadius_mm, double middleDepth_mm, double radius_mm)
{
    const double c = pressureScale(radius_mm);
    const double top = std::max(0.0, middleDepth_mm - sphereRadius_mm), bottom = middleDepth_mm + sphereRadius_mm;
    if (bottom <= top) {
        return 0.0;
    }
    // Share of a disc at depth z: the integral of w over the disc radius has a closed form.
    const auto disc = [&](double z) {
        const double h2 = (z + c) * (z + c), up = z - middleDepth_mm;
        const double rim2 = std::max(0.0, sphereRadius_mm * sphereRadius_mm - up * up) + h2;
        return 3.0 * c * z * z * (1.0 / (h2 * h2) - 1.0 / (rim2 * rim2));
    };
    constexpr int kSteps = 4096; // Simpson's rule
    const double step = (bottom - top) / kSteps;
    double sum = disc(top) + disc(bottom);
    for (int i = 1; i < kSteps; ++i) {
        sum += (i % 2 == 1 ? 4.0 : 2.0) * disc(top + i * step);
    }
    return sum * step / 3.0;
}

double approach(double depth_mm, double press_mm, double radius_mm) noexcept
{
    const double z = std::max(0.0, depth_mm), c = pressureScale(radius_mm), h = z + c;
    const double relativeDisplacement = c * (2.0 * z + c) / (h * h); // u/d of the bell-shaped pressure on its axis
    return std::min(z, press_mm * (1.0 - relativeDisplacement));
}

} // namespace palpate::buried
