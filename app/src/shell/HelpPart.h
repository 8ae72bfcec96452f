// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

namespace palpate::ui {
class KeysCard;
class Tour;
} // namespace palpate::ui

namespace palpate::app {

class ShowAround;

/// Help menu: key card, guided tour, documents; and the setting of single-letter keys.
class HelpPart : public WindowPart
{
    Q_OBJECT
  public:
    explicit HelpPart(const WindowCore& core);
    void addActions() override;

    [[nodiscard]] ShowAround& showAround() noexcept { return *m_around; }
    /// Closes the key card or the tour. @return false if none was open
    bool closeOverlay();

  private:
    void addLetterKeys();

    WindowCore m_core;
    ui::KeysCard* m_keys = nullptr;
    ShowAround* m_around = nullptr;
};

} // namespace palpate::app
