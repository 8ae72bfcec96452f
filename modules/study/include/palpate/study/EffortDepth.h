// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/haptics/HapticScene.h>

#include <cstdint>
#include <span>

namespace palpate::study {

/// A surface in the way of a straight press.
struct PressedSurface
{
    const haptics::HapticStructure* structure = nullptr; ///< never null; outlives this
    std::uint32_t triangle = 0;                          ///< where the press comes in: position in the SurfaceIndex
    core::Vec3 p_W = core::Vec3::Zero();                 ///< on that triangle [mm]
    double entry_mm = 0.0;                               ///< way of the press after which it touches
    double slant = 1.0; ///< depth below the surface for a mm of way: cosine between press and normal, > 0

    /// What the structure pushes back with at rest: its law at that depth, times what the maps of stiffness and of
    /// lumps below say at the place that the press comes in at. Without damping, friction and the force along the
    /// surface that a map's gradient adds. [N]
    /// @param depth_mm  below the surface; 0 and less: no force
    [[nodiscard]] double force_N(double depth_mm) const noexcept;
};

/// What a straight press meets after a way, each surface taken as a plane and their forces as numbers added up. [N]
[[nodiscard]] double forceOfPress_N(std::span<const PressedSurface> surfaces, double way_mm) noexcept;

/// How far a press goes in that is made with a force: the shortest way on which the surfaces push back with it, by
/// bisection. Never shorter for a greater force. Where a law falls, a rise and fall within 1/256 of the way is passed
/// over.
/// @param force_N  0 and less: up to where the first surface is touched
/// @param deepest_mm  of ways; also the answer where the force is not met up to there, or nothing is in the way
/// @par Cost A few hundred look-ups of a law, microseconds. Not for the servo thread.
[[nodiscard]] double wayOfPress_mm(std::span<const PressedSurface> surfaces, double force_N,
                                   double deepest_mm) noexcept;

} // namespace palpate::study
