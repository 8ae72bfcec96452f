// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <functional>

namespace palpate::phantom {

using core::Vec3;

/// Signed distance to a surface, roughly: negative inside, its zero level is the surface. [mm]
using Distance = std::function<double(const Vec3&)>;

/// The organ: a liver-like body of about 200 x 150 x 110 mm, LPS, made of formulas alone.
///
/// A thick right lobe and a wedge-like left lobe are blended, cut from below by a sloping visceral face, and dented
/// where stomach, kidney, colon, gallbladder and inferior vena cava lie, at the liver's gate and at the round ligament.
[[nodiscard]] double organDistance(const Vec3& p);

/// Unit gradient of a distance, by central differences.
[[nodiscard]] Vec3 outward(const Distance& distance, const Vec3& p);

/// Moves a point that is near the surface onto it.
[[nodiscard]] Vec3 onSurface(const Distance& distance, Vec3 p);

/// Where a ray that starts inside leaves.
/// @param direction  unit
[[nodiscard]] Vec3 exitPoint(const Distance& distance, const Vec3& inside, const Vec3& direction);

/// A lump: a slightly uneven ball inside the organ.
struct Lump
{
    Vec3 centre_W;
    double radius_mm;
    Vec3 over_W; ///< place on the organ's surface above it

    [[nodiscard]] double distance(const Vec3& p) const;
};

/// A lump whose top lies `depth_mm` below the organ's surface, where a ray from `inside` along `direction` leaves it.
[[nodiscard]] Lump lumpBelow(const Vec3& inside, const Vec3& direction, double depth_mm, double radius_mm);

} // namespace palpate::phantom
