// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace palpate::evaluation {

/// Force in the corner between two surfaces, pressed along its bisector, over the right force: that of one spring from
/// the corner to the HIP.
/// @par Source Zilles & Salisbury, IROS 1995, figure 3: forces of two vector fields that are summed are right where the
/// surfaces are perpendicular, too large where they are obtuse, twice as large where they are parallel, and too small
/// where they are acute. With an angle a between the surfaces that is 1 - cos a.
struct CornerForce
{
    double angle_deg = 0.0;   ///< between the surfaces: 180 is a plane
    double vectorField = 0.0; ///< both volumes' forces summed
    double godObject = 0.0;   ///< the product
};

/// Measures corners of 20 to 180 degrees, each made of two overlapping boxes.
[[nodiscard]] std::vector<CornerForce> forceInCorners();

} // namespace palpate::evaluation
