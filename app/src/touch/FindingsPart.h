// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

#include <palpate/core/Types.h>

#include <filesystem>
#include <vector>

class FindingsDesk;
class QDockWidget;

namespace palpate::ui {
class FindingsPanel;
}

namespace palpate::app {

class DocumentPart;
class RecordingPart;
class TouchPart;

/// Findings and notes: commands, panel, and the dialogs of import and export.
class FindingsPart : public WindowPart
{
    Q_OBJECT
  public:
    /// The references must outlive this part.
    FindingsPart(const WindowCore& core, DocumentPart& document, TouchPart& touch, RecordingPart& recording);
    ~FindingsPart() override;
    void addActions() override;
    void addPanel(Docks& docks) override;
    void showState(const WindowState& state) override;

    /// Imports the points of a markups file of 3D Slicer (`.mrk.json`).
    void importFrom(const std::filesystem::path& path);

  Q_SIGNALS:
    /// Emitted when the marked places changed. @param places_W  newest last [mm]
    void placesChanged(const std::vector<core::Vec3>& places_W);

  private:
    void raise();
    void exportFindings();
    void importFindings();
    void takeCount(std::size_t count);

    WindowCore m_core;
    DocumentPart& m_document;
    ui::FindingsPanel* m_panel = nullptr;
    FindingsDesk* m_desk = nullptr;
    QDockWidget* m_dock = nullptr;
};

} // namespace palpate::app
