// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/view/TouchCursor.h"

#include <palpate/core/Export.h>
#include <palpate/servo/TickRecord.h>

#include <span>

namespace palpate::view {

/// Converts a servo tick to the state of the cursor, for programs with a render window of their own, such as
/// `resources/examples/own_window`.
///
/// The force is that of the model. For a device with motors replace `f_W` by TickRecord::fSent_W, which is zero after a
/// fault. Friction and dents depend on the tissue and are left out.
/// @param fingertip_mm  radius of the ball-shaped probe [mm], 0: a point
/// @param colours  colour of each structure by number, for the god-objects of inner layers; missing ones are white
/// @par Thread The thread of the view.
[[nodiscard]] PALPATE_EXPORT TouchState stateOf(const servo::TickRecord& tick, double fingertip_mm = 0.0,
                                                std::span<const Colour> colours = {});

} // namespace palpate::view
