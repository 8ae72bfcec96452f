// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/ui/LiveTouch.h>
#include <palpate/ui/Pieces.h>
#include <palpate/ui/SessionPanel.h>

#include <QObject>

#include <filesystem>

/// Controls the current recording: starts and stops, shows the state in chip and session panel, and reports failures.
class RecordingControl : public QObject
{
    Q_OBJECT
  public:
    /// All parameters must outlive this.
    RecordingControl(palpate::ui::LiveTouch& live, palpate::ui::Chip& chip, palpate::ui::SessionPanel& panel,
                     QObject* parent = nullptr);

    /// Sets the folder of new recordings, which is kept in the settings.
    void setFolder(const QString& folder);
    /// Starts a recording in a new file in the set folder, by default in the user's documents. @param scene, embeds  as
    /// for LiveTouch::startRecording
    palpate::core::Status start(const std::filesystem::path& scene, bool embeds);
    /// Stops the recording. @return a description of lost data, if any
    palpate::core::Status stop();
    [[nodiscard]] bool isRecording() const { return m_live.recording().isRecording; }
    /// True from `start` until the recording was stopped or `failed` was emitted.
    [[nodiscard]] bool isOn() const noexcept { return m_isWatching; }
    /// True if the latest recording failed.
    [[nodiscard]] bool hasFailed() const noexcept { return m_hasFailed; }
    /// File of the current or latest recording.
    [[nodiscard]] const std::filesystem::path& path() const noexcept { return m_path; }
    /// Asks the user whether to end a recording in progress, and ends it. @param window  parent of the question
    /// @return true if no recording is running any more
    [[nodiscard]] bool mayEnd(QWidget* window);
    /// Updates chip and panel.
    void refresh();
    /// Clears the failure display: the user has acted since the failure.
    void acknowledge();

  Q_SIGNALS:
    /// The recording failed. @param line  the reason, and missing data
    void failed(const QString& line);
    /// Writing fails at the moment. @param line  the reason
    void writeProblem(const QString& line);

  private:
    palpate::ui::LiveTouch& m_live;
    palpate::ui::Chip& m_chip;
    palpate::ui::SessionPanel& m_panel;
    std::filesystem::path m_path;
    QString m_failure;             ///< shown on the chip until acknowledged
    std::string m_reportedProblem; ///< latest problem reported
    bool m_isWatching = false;
    bool m_hasFailed = false;
};
