// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/SceneDocument.h"
#include "shell/WindowPart.h"

#include <filesystem>
#include <utility>
#include <vector>

namespace palpate::ui {
class MapDisplay;
}

namespace palpate::app {

class RecentFiles;

/// The open document: saving, undo and redo, window title, and the copy of unsaved changes after a crash.
class DocumentPart : public WindowPart
{
    Q_OBJECT
  public:
    /// The references must outlive this part.
    DocumentPart(const WindowCore& core, ui::MapDisplay& maps, RecentFiles& recent);
    void addActions() override;
    void showState(const WindowState& state) override;

    [[nodiscard]] SceneDocument& document() noexcept { return m_document; }
    [[nodiscard]] RecentFiles& recent() noexcept { return m_recent; }
    /// Files from which the scene was opened, or the scene file after saving. Empty without a scene.
    [[nodiscard]] const std::vector<std::filesystem::path>& files() const noexcept { return m_files; }
    /// True if the scene was opened from a recording, which contains the surfaces.
    [[nodiscard]] bool isFromRecording() const;
    /// Sets the files of a newly opened scene, or none.
    void setFiles(std::vector<std::filesystem::path> files) { m_files = std::move(files); }
    /// Shows the files of a newly opened scene in the title and the list of recent files.
    void takeFiles();
    /// Asks whether to save unsaved changes. @return false if the user cancels
    [[nodiscard]] bool confirmDiscard();
    /// Shows the name of the document in the window title.
    void showTitle();
    /// Offers to restore unsaved changes that a crash left, if nothing is open.
    void offerLeftover();

  Q_SIGNALS:
    /// The user wants to open a recent file or a copy of unsaved changes.
    void openWanted(const std::filesystem::path& file);

  private:
    bool save();
    bool saveAs();
    bool saveTo(const std::filesystem::path& path);
    void connectUndo();

    WindowCore m_core;
    ui::MapDisplay& m_maps;
    RecentFiles& m_recent;
    SceneDocument m_document;
    std::vector<std::filesystem::path> m_files;
};

} // namespace palpate::app
