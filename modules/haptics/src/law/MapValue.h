// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/HapticScene.h"

#include <algorithm>
#include <array>

namespace palpate::haptics::law {

/// What a map says at a place of a triangle: linear between its corners, so that the gradient is constant there.
struct MapValue
{
    double value = 1.0;
    Vec3 gradient = Vec3::Zero(); ///< in the triangle's plane [1/mm times the value's unit]

    /// @param triangle  position in the SurfaceIndex; @param corners  of it [mm]
    /// @param p  a place; beyond an edge the value is that of the nearest place in barycentric coordinates
    /// @pre the triangle has an area, as those of an index do
    /// @par Real-time Wait-free.
    [[nodiscard]] static MapValue at(const TissueMap& map, std::uint32_t triangle, const std::array<Vec3, 3>& corners,
                                     const Vec3& p) noexcept
    {
        const std::array<float, 3>& at = (*map.corners)[triangle];
        const Vec3 e1 = corners[1] - corners[0], e2 = corners[2] - corners[0];
        const Vec3 across = e1.cross(e2);
        const double area2 = across.squaredNorm();
        // Gradients of the second and the third barycentric coordinate.
        const Vec3 toSecond = e2.cross(across) / area2, toThird = across.cross(e1) / area2;
        const Vec3 from = p - corners[0];
        const double b1 = std::clamp(toSecond.dot(from), 0.0, 1.0), b2 = std::clamp(toThird.dot(from), 0.0, 1.0 - b1);
        const double d1 = map.factor * (double{at[1]} - double{at[0]}),
                     d2 = map.factor * (double{at[2]} - double{at[0]});
        return {map.factor * double{at[0]} + b1 * d1 + b2 * d2, d1 * toSecond + d2 * toThird};
    }
};

} // namespace palpate::haptics::law
