// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/haptics/HapticScene.h>

#include <cstdint>
#include <span>

namespace palpate::study {

/// Surface along the path of a straight press.
struct PALPATE_EXPORT PressedSurface
{
    const haptics::HapticStructure* structure = nullptr; ///< never null; must outlive this object
    std::uint32_t triangle = 0;                          ///< entry triangle: position in the SurfaceIndex
    core::Vec3 p_W = core::Vec3::Zero();                 ///< entry point on that triangle [mm]
    double entry_mm = 0.0;                               ///< travel of the press at first contact [mm]
    double slant = 1.0; ///< depth per travel: cosine of the angle between press and normal, > 0

    /// Static reaction force: the force law at this depth, scaled by the stiffness and lump maps at the entry point.
    /// Excludes damping, friction and the tangential force of a map gradient. [N]
    /// @param depth_mm  depth below the surface; no force at 0 and below
    [[nodiscard]] double force_N(double depth_mm) const noexcept;
};

/// Returns the total reaction force after a travel [N]. Each surface is approximated by a plane; the force magnitudes
/// are added.
[[nodiscard]] PALPATE_EXPORT double pressForce_N(std::span<const PressedSurface> surfaces, double way_mm) noexcept;

/// Returns the shortest travel of a press at which the surfaces balance a force [mm], by bisection. Monotonic in the
/// force. For a force law with a falling part, a rise and fall within 1/256 of the travel may be missed.
/// @param force_N  0 and below: travel to the first contact
/// @param deepest_mm  maximum travel; also the result if the force is not reached or there is no surface
/// @par Cost A few hundred evaluations of force laws, microseconds. Not for the servo thread.
[[nodiscard]] PALPATE_EXPORT double pressTravel_mm(std::span<const PressedSurface> surfaces, double force_N,
                                                   double deepest_mm) noexcept;

} // namespace palpate::study
