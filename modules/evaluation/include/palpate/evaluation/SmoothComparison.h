// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace palpate::evaluation {

/// How closely a faceted sphere, cylinder or torus is felt as the true one, for one way to hide the facets.
///
/// The ways: facets as they are; PN triangles (geometry::pnTriangles); force shading, which turns the force of the
/// facets into the interpolated vertex normal; and the two-pass god-object, which first moves the goal onto the plane
/// with the interpolated normal and then takes the god-object of the facets for this goal, repeated until it rests.
/// @par Source Zilles & Salisbury, IROS 1995 (the idea of interpolated normals); Morgenbesser & Srinivasan: Force
/// Shading for Haptic Shape Perception (ASME DSC-58, 1996); Ruspini, Kolarov, Khatib: The Haptic Display of Complex
/// Graphical Environments (SIGGRAPH 1997), section 6.
struct SmoothRow
{
    std::string shape;
    std::string way;
    std::size_t triangles = 0;
    double extent_mm = 0.0;     ///< radius of the shape, of the tube for a torus
    double position_mm = 0.0;   ///< largest distance of the god-object from the true surface
    double direction_deg = 0.0; ///< largest angle between the force and that of the true surface
    double step_N = 0.0;        ///< largest change of the force in a tick, sliding at 25 mm/s and a depth of 4 mm
    double work_mJ = 0.0;       ///< largest absolute work of the force on the hand over a closed path, frictionless
    double press_mJ = 0.0;      ///< energy in the spring at that depth, for comparison
};

/// Measures all ways on a sphere of 1,280, a cylinder of 1,792 and a torus of 1,536 triangles, at 0.5 N/mm: one slide
/// at constant depth, and closed paths with a depth of 2.5 to 5.5 mm. Takes about a second.
[[nodiscard]] std::vector<SmoothRow> compareSmoothSurfaces();

} // namespace palpate::evaluation
