// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <functional>

namespace palpate::phantom {

using core::Vec3;

/// Approximate signed distance to a surface: negative inside, zero on the surface. [mm]
using Distance = std::function<double(const Vec3&)>;

/// Organ: a liver-like body of about 200 x 150 x 110 mm in LPS, defined by formulas only.
///
/// A thick right lobe and a wedge-shaped left lobe are blended and cut from below by a sloping visceral face.
/// Indentations mark the stomach, kidney, colon, gallbladder, inferior vena cava, porta hepatis and round ligament.
[[nodiscard]] double organDistance(const Vec3& p);

/// Unit gradient of a distance function, by central differences.
[[nodiscard]] Vec3 outward(const Distance& distance, const Vec3& p);

/// Projects a point near the surface onto the surface.
[[nodiscard]] Vec3 onSurface(const Distance& distance, Vec3 p);

/// Point where a ray from inside leaves the body.
/// @param direction  unit vector
[[nodiscard]] Vec3 exitPoint(const Distance& distance, const Vec3& inside, const Vec3& direction);

/// Lump: a slightly irregular ball inside the organ.
struct Lump
{
    Vec3 centre_W;
    double radius_mm;
    Vec3 over_W; ///< nearest point on the organ's surface above the lump

    [[nodiscard]] double distance(const Vec3& p) const;
};

/// Makes a lump whose top is `depth_mm` below the point where the ray from `inside` along `direction` leaves the
/// organ.
[[nodiscard]] Lump lumpBelow(const Vec3& inside, const Vec3& direction, double depth_mm, double radius_mm);

} // namespace palpate::phantom
