// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/view/Billboard.h>

namespace palpate::test {

/// Returns a view of 600 pixels' height from the front, at a distance from the origin.
inline view::ViewFrame frameAt(double distance_mm)
{
    view::ViewFrame frame;
    frame.eye_W = core::Vec3(0, 0, distance_mm);
    frame.width_px = 800.0;
    frame.height_px = 600.0;
    frame.scale = 0.5;
    return frame;
}

} // namespace palpate::test
