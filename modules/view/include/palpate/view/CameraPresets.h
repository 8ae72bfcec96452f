// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Types.h>

#include <vtkCamera.h>

namespace palpate::view {

/// From where the patient is seen. World is LPS: x to the patient's left, y to the back, z to the head.
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

/// Turns the camera to look at `bounds` from `from`, all of it in view, the patient's head (seen from the head or the
/// feet: the patient's front) up.
/// @param aspect  width over height of the view, > 0
void lookFrom(vtkCamera& camera, ViewFrom from, const core::Box& bounds, double aspect);

/// Moves the camera along its own direction until all of `bounds` is in view.
void fit(vtkCamera& camera, const core::Box& bounds, double aspect);

/// Goes round the focus, which stays in the middle. @param right_deg, up_deg  as the viewer goes
void turn(vtkCamera& camera, double right_deg, double up_deg);

/// Goes along the screen. @param right, up  of the view's height at the focus, as the viewer goes
void shift(vtkCamera& camera, double right, double up);

} // namespace palpate::view
