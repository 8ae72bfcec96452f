// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

class QDockWidget;

namespace palpate::ui {
class DistancesPanel;
class MapDisplay;
class MarginOverlay;
class PointedStructure;
class SceneDistances;
class TapeTool;
} // namespace palpate::ui

namespace palpate::app {

class DocumentPart;
class StatusProgress;
class TouchPart;

/// Distances between structures and between two places: panel, lines in the view and margins on lumps.
class DistancesPart : public WindowPart
{
    Q_OBJECT
  public:
    /// Parts of the window; all must outlive this part.
    struct Parts
    {
        DocumentPart& document;
        TouchPart& touch;
        ui::MapDisplay& maps;
        ui::PointedStructure& pointed;
        StatusProgress& progress;
    };
    DistancesPart(const WindowCore& core, const Parts& parts);
    ~DistancesPart() override;
    void addActions() override;
    void addPanel(Docks& docks) override;
    void showState(const WindowState& state) override;

    /// Gives up a begun tape. @return false if none was begun
    bool cancelTape();

  private:
    void connectDistances();

    WindowCore m_core;
    Parts m_parts;
    ui::SceneDistances* m_distances = nullptr;
    ui::TapeTool* m_tape = nullptr;
    ui::MarginOverlay* m_overlay = nullptr;
    ui::DistancesPanel* m_panel = nullptr;
    QDockWidget* m_dock = nullptr;
};

} // namespace palpate::app
