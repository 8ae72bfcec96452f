// SPDX-License-Identifier: BSD-3-Clause
#pragma once

class QMenu;

namespace palpate::ui {
class LiveTouch;
}

namespace palpate::app {

/// Returns the radius last chosen by the user, 0 = a point. [mm]
[[nodiscard]] double chosenFingertip_mm();

/// Adds the submenu "Fingertip" to `menu`: contact with a point or a ball. The choice is saved in the settings.
void addFingertipMenu(QMenu& menu, ui::LiveTouch& live);

} // namespace palpate::app
