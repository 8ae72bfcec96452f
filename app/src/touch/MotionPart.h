// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

#include <QTimer>

class QDockWidget;

namespace palpate::ui {
class MotionControl;
class MotionPanel;
class PalpationController;
class Playback;
} // namespace palpate::ui

namespace palpate::app {

/// Moving tissue: draws the motion, and has a panel to pause it, hold the breath, and set rate and amplitude. The panel
/// is shown with scenes that move.
class MotionPart : public WindowPart
{
    Q_OBJECT
  public:
    /// The references must outlive this part.
    MotionPart(const WindowCore& core, const ui::Playback& playback, const ui::PalpationController& palpation);
    ~MotionPart() override;
    void addActions() override;
    void addPanel(Docks& docks) override;
    void showState(const WindowState& state) override;

    [[nodiscard]] ui::MotionControl& control() noexcept { return *m_control; }

  private:
    void step();
    void refresh();

    WindowCore m_core;
    const ui::Playback& m_playback;
    const ui::PalpationController& m_palpation;
    ui::MotionControl* m_control = nullptr;
    ui::MotionPanel* m_panel = nullptr;
    QDockWidget* m_dock = nullptr;
    QTimer m_frames;
    bool m_hasMotion = false;
};

} // namespace palpate::app
