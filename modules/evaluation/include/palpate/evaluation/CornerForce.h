// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace palpate::evaluation {

/// Force in the corner between two surfaces when the HIP is pressed in along the bisector, relative to the correct
/// force, which is that of a single spring from the corner to the HIP.
/// @par Source Zilles & Salisbury, IROS 1995, figure 3: the sum of two vector-field forces is correct for
/// perpendicular surfaces, too large for obtuse angles, twice as large for parallel surfaces and too small for acute
/// angles. For an angle a between the surfaces, the ratio is 1 - cos a.
struct CornerForce
{
    double angle_deg = 0.0;   ///< between the surfaces; 180 is a plane
    double vectorField = 0.0; ///< sum of the forces of both volumes
    double godObject = 0.0;   ///< god-object of the product
};

/// Measures corners of 20 to 180 degrees, each built from two overlapping boxes.
[[nodiscard]] std::vector<CornerForce> forceInCorners();

} // namespace palpate::evaluation
