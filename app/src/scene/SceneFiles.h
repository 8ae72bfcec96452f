// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

#include <palpate/ui/SceneLoader.h>

#include <filesystem>
#include <optional>
#include <vector>

class QMimeData;

namespace palpate::ui {
class WelcomePage;
}

namespace palpate::app {

class DocumentPart;
class StatusProgress;

/// Opening of files: dialogs, dropped files, welcome page, progress. The loaded scene arrives as `SceneLoader::opened`.
class SceneFiles : public WindowPart
{
    Q_OBJECT
  public:
    /// The references must outlive this part.
    SceneFiles(const WindowCore& core, DocumentPart& document, StatusProgress& progress, ui::WelcomePage& welcome);
    void addActions() override;
    void showState(const WindowState& state) override;

    [[nodiscard]] ui::SceneLoader& loader() noexcept { return m_loader; }
    /// Opens meshes and scenes as one scene, and the last recording among the files for playback in that scene. Points
    /// of 3D Slicer (`.mrk.json`) are imported as findings, without other files into the open scene.
    void open(const std::vector<std::filesystem::path>& files, const meshio::ReadOptions& options = {});
    /// Adds files to the open scene; a recording among them is opened for playback.
    void add(const std::vector<std::filesystem::path>& files);
    /// Local files in dragged data.
    [[nodiscard]] static std::vector<std::filesystem::path> filesIn(const QMimeData& data);
    /// Opens files that were dropped on the window, or asks whether to add them to the open scene.
    void drop(const std::vector<std::filesystem::path>& files);
    /// Reads the meshes of the open scene again. @param scene  the scene with other axes
    void reopen(meshio::SceneFile scene);
    /// Cancels opening and forgets the unit of the closed scene.
    void forget();
    /// True while a recording waits for its scene.
    [[nodiscard]] bool hasWaitingRecording() const noexcept { return m_waitingRecording.has_value(); }
    /// Opens the recording and the points that waited for their scene, if any.
    void openWaiting();

  Q_SIGNALS:
    /// The user wants to close the scene.
    void closeWanted();
    /// A recording is to be opened for playback.
    void recordingWanted(const std::filesystem::path& path);
    /// Points are to be imported as findings into the open scene.
    void markupsWanted(const std::filesystem::path& path);
    /// A volume is to be shown in sections of the open scene.
    void imageWanted(const std::filesystem::path& path);
    /// Nothing was opened. @param line  the reason, already shown
    void openFailed(const QString& line);

  private:
    void connectLoader();
    void choose();
    bool offerImage(const std::vector<std::filesystem::path>& files, const meshio::ReadOptions& options);
    void openAll(const std::vector<std::filesystem::path>& files, const meshio::ReadOptions& options);
    void chooseAdded();
    void openPhantom();
    void takeFailure(const QString& line);
    void showFailure(const QString& line);
    void offerPart(const QString& line);
    void offerReadingAsMetres(double size_mm);

    WindowCore m_core;
    DocumentPart& m_document;
    StatusProgress& m_progress;
    ui::SceneLoader m_loader;
    std::vector<std::filesystem::path> m_opening;            ///< meshes of the latest request
    meshio::ReadOptions m_options;                           ///< with which these meshes were read
    std::optional<std::filesystem::path> m_waitingRecording; ///< opened once its scene is open
    std::vector<std::filesystem::path> m_waitingMarkups;     ///< same
};

} // namespace palpate::app
