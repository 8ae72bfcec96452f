// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

#include <filesystem>

namespace palpate::ui {
class Playback;
}

namespace palpate::app {

class TouchMapPart;

/// Comparison of the open recording with a second one: timelines with two playheads, map and tables.
class ComparisonPart : public WindowPart
{
    Q_OBJECT
  public:
    /// The references must outlive this part.
    ComparisonPart(const WindowCore& core, ui::Playback& playback, TouchMapPart& map);
    void addActions() override;
    void showState(const WindowState& state) override;
    /// Compares the open recording (A) with another one (B) of the same surfaces.
    void compareWith(const std::filesystem::path& second);

  private:
    void choose();

    WindowCore m_core;
    ui::Playback& m_playback;
    TouchMapPart& m_map;
};

} // namespace palpate::app
