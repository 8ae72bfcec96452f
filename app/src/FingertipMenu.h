// SPDX-License-Identifier: BSD-3-Clause
#pragma once

class QMenu;

namespace palpate::ui {
class LiveTouch;
}

namespace palpate::app {

/// The radius that a person chose last, 0 = a point. [mm]
[[nodiscard]] double chosenFingertip_mm();

/// Adds "Fingertip" to `menu`: what the hand touches with, a point or a ball. The choice is kept for the next start.
void addFingertipMenu(QMenu& menu, ui::LiveTouch& live);

} // namespace palpate::app
