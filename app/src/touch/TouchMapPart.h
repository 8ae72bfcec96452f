// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

#include <palpate/ui/TouchMap.h>

#include <QTimer>

#include <cstdint>
#include <vector>

class QAction;

namespace palpate::ui {
class MapDisplay;
class Playback;
} // namespace palpate::ui

namespace palpate::app {

/// Commands of the map of touch: what the hand has examined, how long, how firmly, and how stiff it was.
class TouchMapPart : public WindowPart
{
    Q_OBJECT
  public:
    /// The references must outlive this part.
    TouchMapPart(const WindowCore& core, ui::MapDisplay& maps, const ui::Playback& playback);
    ~TouchMapPart() override;
    void addActions() override;
    void showState(const WindowState& state) override;
    /// Shows the places touched by the two hands of the player. @param distance_mm  distance that counts as touched in
    /// both
    void compare(double distance_mm);

  private:
    void select(int quantity);
    void restart();
    void sample();

    WindowCore m_core;
    const ui::Playback& m_playback;
    ui::TouchMap* m_map;
    std::vector<QAction*> m_choices; ///< by ui::TouchQuantity
    QTimer m_sampling;
    std::int64_t m_lastTick = 0;
    bool m_isRecording = false;
};

} // namespace palpate::app
