// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Types.h>

#include <vtkCamera.h>

namespace palpate::view {

/// Standard viewing directions. The world frame is LPS: x to the patient's left, y to the back, z to the head.
enum class ViewFrom
{
    Front,
    Back,
    Left,
    Right,
    Head,
    Feet,
    Oblique
};

/// Points the camera at `bounds` from direction `from` and fits all of `bounds` into the view. The patient's head is
/// up; when seen from the head or the feet, the patient's front is up.
/// @param aspect  width over height of the view, > 0
PALPATE_EXPORT void lookFrom(vtkCamera& camera, ViewFrom from, const core::Box& bounds, double aspect);

/// Moves the camera along its viewing direction until all of `bounds` is in view.
PALPATE_EXPORT void fit(vtkCamera& camera, const core::Box& bounds, double aspect);

/// Orbits the camera around its focal point. @param right_deg, up_deg  motion of the viewer
PALPATE_EXPORT void turn(vtkCamera& camera, double right_deg, double up_deg);

/// Pans the camera parallel to the screen. @param right, up  motion of the viewer, in view heights at the focal point
PALPATE_EXPORT void shift(vtkCamera& camera, double right, double up);

} // namespace palpate::view
