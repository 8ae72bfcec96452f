// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

namespace palpate::ui {
class TouchPanel;
}

namespace palpate::app {

class SoundChoice;

/// How touch is shown and heard, and the standard directions of view.
class ViewPart : public WindowPart
{
    Q_OBJECT
  public:
    /// @param touch  source of the sound; must outlive this part
    ViewPart(const WindowCore& core, const ui::TouchPanel& touch);
    void addActions() override;

    [[nodiscard]] SoundChoice& sound() noexcept { return *m_sound; }

  private:
    void addDirections();

    WindowCore m_core;
    const ui::TouchPanel& m_touch;
    SoundChoice* m_sound = nullptr;
};

} // namespace palpate::app
