// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

class QDockWidget;

namespace palpate::ui {
class FeltOverlay;
class FeltPanel;
class LumpMaps;
class MapDisplay;
class PointedStructure;
class SceneLoader;
} // namespace palpate::ui

namespace palpate::app {

class StatusProgress;

/// Palpability of lumps through an organ: colours on the organ and a table.
class LumpsPart : public WindowPart
{
    Q_OBJECT
  public:
    /// Parts of the window; all must outlive this part.
    struct Parts
    {
        ui::MapDisplay& maps;
        ui::PointedStructure& pointed;
        const ui::SceneLoader& loader;
        StatusProgress& progress;
    };
    LumpsPart(const WindowCore& core, const Parts& parts);
    ~LumpsPart() override;
    void addActions() override;
    void addPanel(Docks& docks) override;
    void showState(const WindowState& state) override;

  private:
    void connectMaps();

    WindowCore m_core;
    Parts m_parts;
    ui::LumpMaps* m_lumps = nullptr;
    ui::FeltOverlay* m_overlay = nullptr;
    ui::FeltPanel* m_panel = nullptr;
    QDockWidget* m_dock = nullptr;
};

} // namespace palpate::app
