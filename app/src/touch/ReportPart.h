// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

#include <QString>
#include <QStringList>

#include <filesystem>

namespace palpate::ui {
class Playback;
}

namespace palpate::app {

class DocumentPart;
class ReportRun;

/// Report of the open recording as PDF or HTML. Without a recording, the command offers to record.
class ReportPart : public WindowPart
{
    Q_OBJECT
  public:
    /// The references must outlive this part.
    ReportPart(const WindowCore& core, DocumentPart& document, const ui::Playback& playback);
    void addActions() override;
    void showState(const WindowState& state) override;

    /// Writes the report of the open recording. A name without an extension gets `ending`; a name with an unknown
    /// extension is rejected with a message. @param ending  ".pdf" or ".html"
    void write(std::filesystem::path out, const QString& ending, const QString& caseText, const QString& examiner);

  private:
    void ask();
    void offerRecording();
    void showWritten(const std::filesystem::path& out, const QStringList& missing);
    void openFile(const std::filesystem::path& out);
    [[nodiscard]] int findingsOutside() const;
    void choose(const QString& caseText, const QString& examiner);

    WindowCore m_core;
    DocumentPart& m_document;
    const ui::Playback& m_playback;
    bool m_isRecording = false;
    QString m_offer;   ///< open message that offers to record or to stop
    QString m_written; ///< open message about the last report
};

} // namespace palpate::app
