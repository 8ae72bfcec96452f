// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

namespace palpate::ui {
class Playback;
}

namespace palpate::app {

/// Measures of the open recording, and the setting for surfaces in recordings.
class ResultsPart : public WindowPart
{
    Q_OBJECT
  public:
    /// The references must outlive this part.
    ResultsPart(const WindowCore& core, const ui::Playback& playback);
    void addActions() override;
    void showState(const WindowState& state) override;

  private:
    void show();

    WindowCore m_core;
    const ui::Playback& m_playback;
};

} // namespace palpate::app
