// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace palpate::evaluation {

/// How often a moving surface passes through the hand, for one way to move it.
///
/// The ways: the nodes of the mesh are moved between ticks, and the god-object stays where it was, as Zilles and
/// Salisbury suggest for objects that move or deform; or the hand is pulled back to the rest shape
/// (geometry::SurfaceMotion).
/// @par Source Zilles & Salisbury, IROS 1995, doi:10.1109/IROS.1995.525876 (moving nodes)
struct MotionRow
{
    std::string motion;
    std::string way;
    std::size_t ticks = 0;
    std::size_t touched = 0; ///< ticks in contact
    std::size_t passes = 0;  ///< times the god-object got to the other side of the surface
    double share = 0.0;      ///< share of the ticks that it spent there
};

/// Measures both ways on a plate without thickness at 2 m/s, a sphere that oscillates by ±20 mm at 0.25 and 50 Hz, and
/// a sphere in random frames with a strain of 30 %, at 1 kHz. Takes some seconds: every tick of the first way builds
/// the index of the moved mesh.
[[nodiscard]] std::vector<MotionRow> compareMotions();

} // namespace palpate::evaluation
