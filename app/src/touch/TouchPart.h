// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

namespace palpate::ui {
class Chip;
class PalpationController;
class StructurePanel;
class TouchPanel;
} // namespace palpate::ui

namespace palpate::app {

/// Palpation with the pointer, the panel of current values, and the chip with the state of the hand.
class TouchPart : public WindowPart
{
    Q_OBJECT
  public:
    /// @param structures  marks the depth in its plot of the force law; must outlive this part
    TouchPart(const WindowCore& core, ui::StructurePanel& structures);
    ~TouchPart() override;
    void addActions() override;
    void addPanel(Docks& docks) override;
    void showState(const WindowState& state) override;

    [[nodiscard]] ui::PalpationController& palpation() noexcept { return *m_palpation; }
    [[nodiscard]] ui::TouchPanel& panel() noexcept { return *m_panel; }
    /// Switches between palpation and camera.
    void setPalpating(bool isPalpating);
    /// Lifts the hand off the surface, or else switches to the camera.
    void letGo();

  Q_SIGNALS:
    /// Emitted before palpation begins.
    void palpationBegins();
    /// Emitted after palpation began or ended.
    void palpationChanged();
    /// Emitted for Esc. Call `letGo` unless Esc closes the key card or the tour.
    void letGoWanted();

  private:
    void addGestures();
    void connectView();
    void showHand();
    [[nodiscard]] QString handText() const;

    WindowCore m_core;
    ui::TouchPanel* m_panel = nullptr;
    ui::PalpationController* m_palpation = nullptr;
    ui::Chip& m_chip;
};

} // namespace palpate::app
