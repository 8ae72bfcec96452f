// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/SurfaceMotion.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate::geometry::internal {

/// Gives the outermost control points of every frame the values of their neighbours, so that the displacement has no
/// slope across the rim of the lattice.
void closeRim(const MotionLattice& lattice, std::vector<std::array<double, 4>>& controls);

struct WorstStrain
{
    double strain = 0.0; ///< bound on the principal values of the displacement gradient [1]
    std::size_t frame = 0;
    std::array<std::uint32_t, 3> cell{};
};

/// Bounds the displacement gradient over all places and times. In a cell the gradient is a mean of its Bernstein
/// coefficients, and between two frames the periodic cubic is a mean of four Bernstein frames: c_i, c_i + m_i / 3,
/// c_(i+1) − m_(i+1) / 3 and c_(i+1), with the slopes m_i = (c_(i+1) − c_(i−1)) / 2. The norm of a mean is at most the
/// largest norm, so the largest of these coefficients is a bound, not a sample.
/// @par Source Farin, Curves and Surfaces for CAGD (2002), sections 5 and 7 (Bernstein form, convex hull)
/// @par Cost about 1 µs per cell and frame that moves
[[nodiscard]] WorstStrain worstStrain(const MotionLattice& lattice, std::size_t frames,
                                      const std::vector<std::array<double, 4>>& controls);

} // namespace palpate::geometry::internal
