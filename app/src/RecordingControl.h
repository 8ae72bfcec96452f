// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/ui/LiveTouch.h>
#include <palpate/ui/Pieces.h>
#include <palpate/ui/SessionPanel.h>

#include <QObject>

#include <filesystem>

/// The recording that runs: begins and ends it, says in chip and session panel how it goes, and tells when it ended by
/// itself.
class RecordingControl : public QObject
{
    Q_OBJECT
  public:
    /// All must outlive this.
    RecordingControl(palpate::ui::LiveTouch& live, palpate::ui::Chip& chip, palpate::ui::SessionPanel& panel,
                     QObject* parent = nullptr);

    /// Records into a new file in the user's documents. @param scene, embeds  as LiveTouch::startRecording
    palpate::core::Status start(const std::filesystem::path& scene, bool embeds);
    /// @return what was lost, if anything
    palpate::core::Status stop();
    [[nodiscard]] bool isRecording() const { return m_live.recording().isRecording; }
    /// True from `start` until it was stopped, or `failed` told that it ended by itself.
    [[nodiscard]] bool isOn() const noexcept { return m_isWatching; }
    /// The one that was last on ended by itself.
    [[nodiscard]] bool hasFailed() const noexcept { return m_hasFailed; }
    /// The file that is being written, or was last.
    [[nodiscard]] const std::filesystem::path& path() const noexcept { return m_path; }
    /// True when nothing runs, or a person agreed to end it, and it is ended. @param window  that asks
    [[nodiscard]] bool mayEnd(QWidget* window);
    /// Chip and panel say how it goes.
    void refresh();
    /// A person did something: what failed has been seen.
    void acknowledge();

  Q_SIGNALS:
    /// The recording ended by itself. @param line  why, and what is missing
    void failed(const QString& line);
    /// Writing fails for now. @param line  why
    void troubled(const QString& line);

  private:
    palpate::ui::LiveTouch& m_live;
    palpate::ui::Chip& m_chip;
    palpate::ui::SessionPanel& m_panel;
    std::filesystem::path m_path;
    QString m_failure;  ///< on the chip, until it is acknowledged
    std::string m_told; ///< trouble that was told
    bool m_isWatching = false;
    bool m_hasFailed = false;
};
