// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"
#include "touch/RecordingControl.h"
#include "touch/RecordingTrace.h"

#include <QString>
#include <filesystem>
#include <vector>

namespace palpate::ui {
class Playback;
}

namespace palpate::app {

class DocumentPart;
class TouchPart;

/// Recording and playback: commands, panel and chip.
class RecordingPart : public WindowPart
{
    Q_OBJECT
  public:
    /// The references must outlive this part.
    RecordingPart(const WindowCore& core, DocumentPart& document, TouchPart& touch);
    ~RecordingPart() override;
    void addActions() override;
    void addPanel(Docks& docks) override;
    void showState(const WindowState& state) override;

    [[nodiscard]] ui::Playback& playback() noexcept { return *m_playback; }
    /// State of the window, which depends on scene and recording.
    [[nodiscard]] WindowState windowState() const;
    [[nodiscard]] bool isRecording() const { return m_control->isRecording(); }
    /// Opens a recording for playback. Without a scene, the recording is shown alone.
    void open(const std::filesystem::path& path);
    /// Starts or stops a recording.
    void toggle();
    /// Asks whether to end a recording in progress. @return false if the recording goes on
    [[nodiscard]] bool mayEnd();
    /// Clears the display of a failed recording: the user has acted since the failure.
    void acknowledge() { m_control->acknowledge(); }
    /// Sets the fingertip radius: as recorded if the scene was opened from the open recording, otherwise as last chosen
    /// by the user.
    void takeFingertip();

  Q_SIGNALS:
    /// A recording without a scene is open and drawn.
    void shownAlone();
    /// Emitted when the user has chosen the meshes of a recording. @param files  these and the recording
    void meshesFound(const std::vector<std::filesystem::path>& files);
    void openFailed(const QString& line);
    /// Emitted after a recording was started, or failed to start, in this file.
    void begun(const std::filesystem::path& path);
    /// Emitted after a recording was stopped by the user.
    void ended();

  private:
    void start();
    void findMeshes(const std::filesystem::path& recording);
    void stop();
    void togglePlaying();
    void takeFailure(const QString& line);
    void offerInterrupted();
    void showForceLimit(const WindowState& state);

    WindowCore m_core;
    DocumentPart& m_document;
    TouchPart& m_touch;
    ui::SessionPanel* m_panel = nullptr;
    ui::Playback* m_playback = nullptr;
    RecordingControl* m_control = nullptr;
    RecordingTrace m_trace;
    QString m_told; ///< the open message about the last recording
};

} // namespace palpate::app
