// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

class QMenu;

namespace palpate::ui {
class Chip;
}

namespace palpate::app {

/// Returns the radius last chosen by the user, 0 = a point; 8 mm before the first choice. [mm]
[[nodiscard]] double chosenFingertip_mm();

/// The contact shape of the hand, a point or a ball: submenu "Fingertip" and a chip that opens the same menu. The
/// choice is saved in the settings.
class FingertipPart : public WindowPart
{
    Q_OBJECT
  public:
    explicit FingertipPart(const WindowCore& core);
    void addActions() override;
    void showState(const WindowState& state) override;

  private:
    void fill();
    void showChip();

    WindowCore m_core;
    QMenu& m_menu;
    ui::Chip& m_chip;
};

} // namespace palpate::app
