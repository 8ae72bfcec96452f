// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

#include <QStringList>

class QDockWidget;

namespace palpate::servo {
struct RealtimeReport;
}

namespace palpate::ui {
class Chip;
class EngineeringPanel;
class HandControl;
class TouchPanel;
} // namespace palpate::ui

namespace palpate::app {

/// State of the servo loop: chip, panel with numbers, and warnings about settings that disturb the loop.
class EngineeringPart : public WindowPart
{
    Q_OBJECT
  public:
    /// The references must outlive this part.
    EngineeringPart(const WindowCore& core, const ui::TouchPanel& touch, ui::HandControl& hand);
    ~EngineeringPart() override;
    void addActions() override;
    void addPanel(Docks& docks) override;
    void showState(const WindowState& state) override;

  private:
    void refresh();
    void listWarnings(const servo::RealtimeReport& report);

    WindowCore m_core;
    const ui::TouchPanel& m_touch;
    ui::EngineeringPanel* m_panel = nullptr;
    ui::Chip& m_chip;
    QDockWidget* m_dock = nullptr;
    QStringList m_warnings; ///< as last listed
};

} // namespace palpate::app
