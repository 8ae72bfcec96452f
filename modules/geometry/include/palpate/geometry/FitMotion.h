// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/SurfaceMotion.h"

#include <span>

namespace palpate::geometry {

/// A motion fitted to given shapes.
struct FittedMotion
{
    std::shared_ptr<const SurfaceMotion> motion;
    double residual_mm = 0.0; ///< largest distance of a vertex from its given place, over all frames
    std::size_t frame = 0;    ///< where that is
    std::size_t vertex = 0;
};

/// Largest accepted residual [mm].
inline constexpr double kMaxResidual_mm = 1.0;

/// Fits a lattice to the vertices of a surface at equal steps of a period, by least squares. Where no vertex is near,
/// the displacement is harmonic.
/// @param rest  vertices of the rest shape [mm]
/// @param frames  the same vertices at each step [mm]
/// @param spacing_mm  edge of the lattice's cells; made larger where the lattice would exceed 40 cells along an axis
/// @return OutOfRange: another number of vertices, or a residual above kMaxResidual_mm, with frame and vertex;
///         otherwise as SurfaceMotion::frames
/// @par Cost seconds for 50,000 vertices and 5,000 cells
[[nodiscard]] PALPATE_EXPORT core::Result<FittedMotion>
fitMotion(double period_s, std::span<const Vec3> rest, const std::vector<std::vector<Vec3>>& frames, double spacing_mm);

/// Fits a lattice to the vertices of a surface that goes from its rest shape to another shape and back once a period,
/// displaced by sin^exponent(π t / period).
/// @param exponent  even, at least 2
/// @param full  the vertices of the other shape [mm]
/// @return otherwise as fitMotion; the frame is 0
[[nodiscard]] PALPATE_EXPORT core::Result<FittedMotion>
fitBreath(double period_s, int exponent, std::span<const Vec3> rest, const std::vector<Vec3>& full, double spacing_mm);

} // namespace palpate::geometry
